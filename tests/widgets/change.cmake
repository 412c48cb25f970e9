# SPDX-License-Identifier: GPL-3.0-or-later
hitscope_test(histogram LABEL widgets SOURCES ${CMAKE_CURRENT_LIST_DIR}/histogram_test.cpp LINK hitscope_panels)
