# SPDX-License-Identifier: GPL-3.0-or-later
hitscope_test(frame_rate LABEL widgets SOURCES ${CMAKE_CURRENT_LIST_DIR}/frame_rate_test.cpp LINK hitscope_panels)
hitscope_test(dent_measurement LABEL widgets SOURCES ${CMAKE_CURRENT_LIST_DIR}/dent_measurement_test.cpp LINK hitscope_panels)
