# SPDX-License-Identifier: GPL-3.0-or-later
hitscope_test(memory LABEL unit SOURCES ${CMAKE_CURRENT_LIST_DIR}/memory_test.cpp LINK hitscope_core)
