# SPDX-License-Identifier: GPL-3.0-or-later
hitscope_test(inspect LABEL widgets SOURCES ${CMAKE_CURRENT_LIST_DIR}/inspect_test.cpp LINK hitscope_app TIMEOUT 300)
