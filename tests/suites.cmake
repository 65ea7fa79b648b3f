# Each suite of a test program of googletest is one test of ctest, PROGRAM.SUITE. To start a program that is linked with the
# whole solver, and with what reads meshes, takes longer than most tests: a start for each of 3,600 took minutes.
#   cmake -D PROGRAM=FILE -D LABEL=ROOM -D FIXTURE=NAME -D FILTER=FILTER -D LISTING=FILE -P suites.cmake
# writes them to LISTING, which ctest reads. FILTER is one of googletest. FIXTURE may be empty; else each test is one by itself,
# since they take long, and all of them set up this fixture: a folder of that name, beside LISTING, for what they leave, which
# the environment tells them as PINBALL_NAME.
cmake_minimum_required(VERSION 3.25)
execute_process(COMMAND ${PROGRAM} --gtest_list_tests --gtest_filter=${FILTER} OUTPUT_VARIABLE listed COMMAND_ERROR_IS_FATAL ANY)
get_filename_component(folder ${PROGRAM} DIRECTORY)
get_filename_component(program ${PROGRAM} NAME)

# A suite is skipped if all of its tests are: a test that fails is listed after those that were skipped.
set(skipped "\\[  PASSED  \\] 0 tests\\.\n(\\[  SKIPPED \\][^\n]*\n?)+$")
set(environment GOMP_SPINCOUNT=1000)  # tests run side by side: their threads must not wait for each other busily (see main.cpp)
set(more)
if(FIXTURE)
  get_filename_component(beside ${LISTING} DIRECTORY)
  string(TOUPPER ${FIXTURE} variable)
  string(APPEND environment ";PINBALL_${variable}=${beside}/${FIXTURE}")
  set(more "FIXTURES_SETUP ${FIXTURE}")
endif()
function(add name filter cost)
  set(name "[=[${program}.${name}]=]")
  file(APPEND ${LISTING} "add_test(${name} [==[${PROGRAM}]==] [==[--gtest_filter=${filter}]==])\n"
    "set_tests_properties(${name} PROPERTIES WORKING_DIRECTORY [==[${folder}]==] LABELS ${LABEL} COST ${cost}\n"
    "  ENVIRONMENT [==[${environment}]==] ${more} SKIP_REGULAR_EXPRESSION [==[${skipped}]==])\n")
endfunction()

# SUITE. or, of one for several types, SUITE/NUMBER. begin a line; the tests of it follow, set in.
file(WRITE ${LISTING} "")
string(REGEX REPLACE "[^\n]*Running main[^\n]*\n" "" listed "${listed}")
string(REGEX MATCHALL "[^\n]+" lines "${listed}")
set(suites)
foreach(line IN LISTS lines)
  string(REGEX REPLACE " *#.*" "" line "${line}")
  if(NOT line MATCHES "^ ")
    string(REGEX REPLACE "\\.$" "" name ${line})
    string(REGEX REPLACE "/[0-9]+$" "" suite ${name})
    list(APPEND suites ${suite})
    set(filter_of_${suite} "${filter_of_${suite}}:${name}.*")
  elseif(FIXTURE OR suite STREQUAL "Mock")  # what was shown of the mock's memory is a state of the process
    string(STRIP "${line}" test)
    set(cost 1)
    if(FIXTURE)
      set(cost 10)
    endif()
    add(${name}.${test} ${name}.${test} ${cost})
  else()
    math(EXPR tests_of_${suite} "0${tests_of_${suite}} + 1")
  endif()
endforeach()
if(NOT FIXTURE)
  list(REMOVE_DUPLICATES suites)
  list(REMOVE_ITEM suites Mock)
  foreach(suite IN LISTS suites)
    string(REGEX REPLACE "^:" "" filter ${filter_of_${suite}})
    # Long ones begin before short ones, so that none runs on alone at the end; how many tests there are tells enough of it.
    math(EXPR hundredths "1000 + ${tests_of_${suite}}")
    string(SUBSTRING ${hundredths} 1 1 whole)
    string(SUBSTRING ${hundredths} 2 2 rest)
    add(${suite} "${filter}" ${whole}.${rest})
  endforeach()
endif()
