# Writes HEADER with the commit of SOURCE, unless it holds it already.
execute_process(COMMAND git -C ${SOURCE} describe --always --dirty --abbrev=10 --exclude=*
  OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
if(failed)
  set(commit "not known")
endif()
file(CONFIGURE OUTPUT ${HEADER} CONTENT "#define GLISSADE_COMMIT \"${commit}\"\n")
