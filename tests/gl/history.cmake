# SPDX-License-Identifier: GPL-3.0-or-later
hitscope_test(shown_hits LABEL gl SOURCES ${CMAKE_CURRENT_LIST_DIR}/shown_hits_test.cpp LINK hitscope_session)
