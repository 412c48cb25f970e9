# SPDX-License-Identifier: GPL-3.0-or-later
hitscope_test(pipeline_agreement LABEL models SOURCES ${CMAKE_CURRENT_LIST_DIR}/pipeline_agreement_test.cpp LINK hitscope_session)
hitscope_test(task_list LABEL models SOURCES ${CMAKE_CURRENT_LIST_DIR}/task_list_test.cpp LINK hitscope_session)
