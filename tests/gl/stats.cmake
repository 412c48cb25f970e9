# SPDX-License-Identifier: GPL-3.0-or-later
hitscope_test(reapplication LABEL gl SOURCES ${CMAKE_CURRENT_LIST_DIR}/reapplication_test.cpp LINK hitscope_session)
