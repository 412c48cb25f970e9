# SPDX-License-Identifier: GPL-3.0-or-later
hitscope_test(bench LABEL cli SOURCES ${CMAKE_CURRENT_LIST_DIR}/bench_test.cpp LINK Qt6::Core)
set_property(TEST cli.bench APPEND PROPERTY ENVIRONMENT "HITSCOPE_CLI=$<TARGET_FILE:hitscope-cli>")
add_dependencies(test_cli_bench hitscope-cli)
hitscope_test(bench LABEL gl
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/bench_gl_test.cpp ${CMAKE_CURRENT_LIST_DIR}/../support/gl_fixture.cpp
  LINK hitscope_bench)
