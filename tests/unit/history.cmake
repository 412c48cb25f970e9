# SPDX-License-Identifier: GPL-3.0-or-later
hitscope_test(history_effects LABEL unit SOURCES ${CMAKE_CURRENT_LIST_DIR}/history_effects_test.cpp LINK hitscope_deform)
hitscope_test(hit_effects LABEL unit SOURCES ${CMAKE_CURRENT_LIST_DIR}/hit_effects_test.cpp LINK hitscope_session)
