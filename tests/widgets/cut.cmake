# SPDX-License-Identifier: GPL-3.0-or-later
hitscope_test(cut LABEL widgets SOURCES ${CMAKE_CURRENT_LIST_DIR}/cut_test.cpp LINK hitscope_app TIMEOUT 300)
