# SPDX-License-Identifier: GPL-3.0-or-later
hitscope_test(statistics_window LABEL widgets SOURCES ${CMAKE_CURRENT_LIST_DIR}/statistics_window_test.cpp LINK hitscope_app TIMEOUT 300)
