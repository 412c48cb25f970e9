# SPDX-License-Identifier: GPL-3.0-or-later
hitscope_test(session_history LABEL unit SOURCES ${CMAKE_CURRENT_LIST_DIR}/session_history_test.cpp LINK hitscope_session)
