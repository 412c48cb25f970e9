# SPDX-License-Identifier: GPL-3.0-or-later
hitscope_test(exactness LABEL widgets SOURCES ${CMAKE_CURRENT_LIST_DIR}/exactness_test.cpp LINK hitscope_app TIMEOUT 300)
