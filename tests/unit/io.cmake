# SPDX-License-Identifier: GPL-3.0-or-later
foreach(test obj ply stl mutations)
  hitscope_test(io_${test} LABEL unit LINK hitscope_io_readers
    SOURCES ${CMAKE_CURRENT_LIST_DIR}/io_${test}_test.cpp ${CMAKE_CURRENT_LIST_DIR}/io_support.h
            ${CMAKE_CURRENT_LIST_DIR}/io_support.cpp)
endforeach()
