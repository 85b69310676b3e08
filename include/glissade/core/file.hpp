// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace glissade {

class OutputFile;

/// The whole file, byte for byte: a regular file, or a pipe that this process has open (/dev/stdin,
/// <(command) of a shell). Throws InputError when it cannot be read, is a named pipe, a device or a
/// socket, which might never end or never begin, or has more than 256 MiB.
std::string read_text_file(const std::filesystem::path& path);

/// Writes a file whole or not at all: to a new file, `path` + ".partial.<process id>", flushed to
/// the disk, then renamed over `path`, so that a reader never sees half of it and a full disk
/// leaves the old file as it was. A file or link that already has the new file's name is left alone
/// and another name is taken. What is there and is not a regular file
/// (/dev/stdout, /dev/full, a pipe) is written to directly; a symbolic link is followed. Missing
/// folders are made. Throws InputError with the path, the system's reason and what to do.
void write_text_file(const std::filesystem::path& path, std::string_view text);

/// The same of regular files only, with a function that writes the partial file, which is there and
/// empty, through `file`.
using WriteFile = std::function<void(OutputFile& file, const std::filesystem::path& partial)>;
void write_file(const std::filesystem::path& path, const WriteFile& write);

/// Makes a file that must not be there yet; of several processes that try, one succeeds. Throws
/// InputError for the others.
void create_text_file(const std::filesystem::path& path, std::string_view text);

/// "a.csv" of "a.csv.partial.4711" or "a.csv.partial.4711.1", which a writer of a.csv left that was
/// killed; empty for any other name.
std::string whole_name(const std::string& partial_name);

/// Flushes the names of a folder's files to the disk, where the file system can.
void sync_folder(const std::filesystem::path& folder);

}  // namespace glissade
