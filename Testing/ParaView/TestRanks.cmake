# Runs TestRanks.py on 1, 2 and 4 ranks: they must print the same results and share the work.
foreach (ranks IN ITEMS 1 2 4)
  execute_process(
    COMMAND "${MPIRUN}" --oversubscribe -np ${ranks} "${PVBATCH}"
      "${CMAKE_CURRENT_LIST_DIR}/TestRanks.py"
    OUTPUT_VARIABLE output RESULT_VARIABLE result)
  if (NOT result EQUAL 0)
    message(FATAL_ERROR "${ranks} ranks: pvbatch returned ${result}\n${output}")
  endif ()
  string(REGEX MATCHALL "RESULT [^\n]*" lines "${output}")
  message(STATUS "${ranks} ranks: ${lines}")
  if (ranks EQUAL 1)
    set(expected "${lines}")
  endif ()
  if (NOT output MATCHES "SHARE ([0-9])" OR (ranks GREATER 1 AND CMAKE_MATCH_1 GREATER 2))
    message(FATAL_ERROR "${ranks} ranks: the first has ${CMAKE_MATCH_1} of 5 objects")
  endif ()
  list(LENGTH lines count)
  if (NOT count EQUAL 14 OR NOT lines STREQUAL expected)
    message(FATAL_ERROR "${ranks} ranks give other results than one")
  endif ()
endforeach ()
