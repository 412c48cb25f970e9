# SPDX-License-Identifier: GPL-3.0-or-later
hitscope_test(navigation LABEL unit SOURCES ${CMAKE_CURRENT_LIST_DIR}/navigation_test.cpp LINK hitscope_viewport)
