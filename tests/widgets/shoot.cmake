# SPDX-License-Identifier: GPL-3.0-or-later
hitscope_test(time LABEL widgets SOURCES ${CMAKE_CURRENT_LIST_DIR}/time_test.cpp LINK hitscope_app TIMEOUT 300)
hitscope_test(shots LABEL widgets SOURCES ${CMAKE_CURRENT_LIST_DIR}/shots_test.cpp LINK hitscope_app TIMEOUT 300)
