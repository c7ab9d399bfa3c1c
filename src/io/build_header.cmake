#Writes OUTPUT, a header that says what is being built, when that has changed.
#The commit is asked for at each build, so that it is the one that was built.
execute_process(COMMAND git -C ${SOURCE} rev-parse --show-toplevel
                OUTPUT_VARIABLE top OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
if(top)
  get_filename_component(top ${top} REALPATH)
  get_filename_component(source ${SOURCE} REALPATH)
endif()
if(top AND top STREQUAL source) # not a repository around an unpacked archive
  execute_process(COMMAND git -C ${SOURCE} describe --always --dirty --abbrev=40 --exclude=*
                  OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
endif()
if(NOT commit)
  set(commit unknown)
endif()
file(WRITE ${OUTPUT}.new "#define CLACK_VERSION \"${VERSION}\"
#define CLACK_COMMIT \"${commit}\"
#define CLACK_FLAGS \"${FLAGS}\"
")
execute_process(COMMAND ${CMAKE_COMMAND} -E copy_if_different ${OUTPUT}.new ${OUTPUT})
