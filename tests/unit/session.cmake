# SPDX-License-Identifier: GPL-3.0-or-later
hitscope_test(session_undo LABEL unit SOURCES ${CMAKE_CURRENT_LIST_DIR}/session_undo_test.cpp LINK hitscope_session)
hitscope_test(session LABEL unit SOURCES ${CMAKE_CURRENT_LIST_DIR}/session_test.cpp LINK hitscope_session)
hitscope_test(constants_setting LABEL unit SOURCES ${CMAKE_CURRENT_LIST_DIR}/constants_setting_test.cpp
  LINK hitscope_session)
