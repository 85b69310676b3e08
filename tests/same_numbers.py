#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compares results files of format version 3 (three kinds of study) with those of version 4 and 5 (one kind), dataset by dataset.

  tests/same_numbers.py OLD/results.h5 NEW/results.h5      needs the Debian package python3-h5py

Prints 'same' for datasets with the same bits, and what differs for the others. Exit status 1 if any differs.
The studies of both versions, in a folder each:  for s in studies/*.toml; do glissade run $s --out DIR/$(basename $s .toml); done
"""
import sys

import h5py
import numpy as np

CLEARANCE_FIELDS = {"peak_m": "peak_vector_m", "peak_along_m": "peak_along_m", "peak_across_m": "peak_across_m",
                    "residual_along_m": "residual_along_m", "residual_across_m": "residual_across_m",
                    "shear_along": "shear_along", "shear_across": "shear_across", "uplift": "uplift"}
# Of the axes of a clearance study's grid: support, vertical, R, mass, slope, level, period.
GRID_AXES = {"array.support": 0, "building.response_modification": 2, "building.mass_ratio": 3, "roof.slope_deg": 4,
             "building.period_s": 6}


class Comparison:
    def __init__(self):
        self.differing = 0

    def compare(self, name, old, new):
        old, new = np.asarray(old), np.asarray(new)
        if old.shape == new.shape and np.array_equal(old, new, equal_nan=old.dtype.kind == "f"):
            print("same", name, old.shape)
            return
        self.differing += 1
        if old.shape != new.shape:
            print("SHAPE", name, old.shape, new.shape)
            return
        with np.errstate(invalid="ignore"):
            unequal = ~((old == new) | (np.isnan(old) & np.isnan(new)))
            largest = np.max(np.abs(old - new)[unequal] / np.maximum(np.abs(old[unequal]), 1e-300))
        print("DIFFERS", name, old.shape, "in", int(unequal.sum()), "values, relative", largest)

    def group(self, name, old, new):
        def visit(path, dataset):
            if isinstance(dataset, h5py.Dataset) and dataset.dtype.kind in "fiu" and path in new:
                self.compare(f"{name}/{path}", dataset[()], new[path][()])

        old.visititems(visit)


def compare_runs(comparison, old, new):
    """Fragility studies: a run of old is a combination of new."""
    for label in (text.decode() for text in old["runs/label"][()]):
        if label == "chart":
            continue
        run, combination = old["runs"][label], new["runs"][label]
        first, count = int(combination.attrs["first_case"]), int(combination.attrs["cases"])
        for field, dataset in new["histories"].items():
            before = run[field] if field in run else run.get("impact/" + field)
            if before is not None and before.size:
                comparison.compare(f"{label}/{field}", before[()], dataset[()][:, first:first + count])
        for group in ("fragility", "slip", "standards", "impact"):
            if group in run and group in combination:
                comparison.group(f"{label}/{group}", run[group], combination[group])
    if "chart" in old:
        comparison.group("chart", old["chart"], new["chart"])


def place_on(axis, key, grid, position):
    values = axis["value"][()]
    if key in GRID_AXES:
        return position[GRID_AXES[key]]
    if key == "vertical.use":
        return [name.decode() for name in axis["name"][()]].index(grid["vertical"][position[1]].decode())
    found = np.where(values == grid["vertical_period_s"][position[1]])[0]
    return int(found[0]) if len(found) else 0  # with no vertical: any period


def compare_clearance(comparison, old, new):
    """Clearance studies: by record, orientation and condition."""
    grid, orientations = old["grid"], int(new["cases"].attrs["orientations"])
    keys = [key.decode() for key in new["cases/axes/key"][()]]
    axes = [new[f"cases/axes/axis_{i}"] for i in range(len(keys))]
    shape = [len(grid[name]) for name in ("support", "vertical", "response_modification", "mass_ratio", "slope_deg",
                                          "fraction_of_mce", "period_s")]
    for before, after in CLEARANCE_FIELDS.items():
        expected, cases = old["histories"][before][()], new["histories"][after][()]
        found = np.zeros_like(expected)
        for condition in range(int(np.prod(shape))):
            position = np.unravel_index(condition, shape)
            combination = 0
            for key, axis in zip(keys, axes):
                combination = combination * len(axis["value"]) + place_on(axis, key, grid, position)
            for orientation in range(orientations):
                found[:, orientation, condition] = cases[:, combination * orientations + orientation, position[5]]
        comparison.compare(before, expected, found)


def main(old_file, new_file):
    comparison = Comparison()
    with h5py.File(old_file) as old, h5py.File(new_file) as new:
        (compare_runs if "runs" in old else compare_clearance)(comparison, old, new)
    return 1 if comparison.differing else 0


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    sys.exit(main(sys.argv[1], sys.argv[2]))
