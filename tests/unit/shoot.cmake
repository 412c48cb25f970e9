# SPDX-License-Identifier: GPL-3.0-or-later
hitscope_test(shot_script LABEL unit SOURCES ${CMAKE_CURRENT_LIST_DIR}/shot_script_test.cpp LINK hitscope_session)
hitscope_test(shot_script_file LABEL unit SOURCES ${CMAKE_CURRENT_LIST_DIR}/shot_script_file_test.cpp LINK hitscope_session)
hitscope_test(dent_preview LABEL unit SOURCES ${CMAKE_CURRENT_LIST_DIR}/dent_preview_test.cpp LINK hitscope_session)
