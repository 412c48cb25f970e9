# SPDX-License-Identifier: GPL-3.0-or-later
foreach(test export materials mutations obj ply stl)
  hitscope_test(io_${test} LABEL unit LINK hitscope_io_readers
    SOURCES ${CMAKE_CURRENT_LIST_DIR}/io_${test}_test.cpp ${CMAKE_CURRENT_LIST_DIR}/io_support.h
            ${CMAKE_CURRENT_LIST_DIR}/io_support.cpp)
endforeach()
foreach(test bad_input formats stream worker)
  hitscope_test(io_${test} LABEL unit LINK hitscope_io
    SOURCES ${CMAKE_CURRENT_LIST_DIR}/io_${test}_test.cpp ${CMAKE_CURRENT_LIST_DIR}/io_support.h
            ${CMAKE_CURRENT_LIST_DIR}/io_support.cpp)
  add_dependencies(test_unit_io_${test} hitscope-import)
endforeach()
