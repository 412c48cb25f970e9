# SPDX-License-Identifier: GPL-3.0-or-later
hitscope_test(exact_arithmetic LABEL unit SOURCES ${CMAKE_CURRENT_LIST_DIR}/exact_arithmetic_test.cpp LINK hitscope_deform)
