# SPDX-License-Identifier: GPL-3.0-or-later
foreach(test harness arguments report)
  hitscope_test(bench_${test} LABEL unit SOURCES ${CMAKE_CURRENT_LIST_DIR}/bench_${test}_test.cpp LINK hitscope_bench_harness)
endforeach()
