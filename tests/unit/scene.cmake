# SPDX-License-Identifier: GPL-3.0-or-later
hitscope_test(session_targets LABEL unit SOURCES ${CMAKE_CURRENT_LIST_DIR}/session_targets_test.cpp LINK hitscope_session)
hitscope_test(scene_primitives LABEL unit SOURCES ${CMAKE_CURRENT_LIST_DIR}/scene_primitives_test.cpp LINK hitscope_session)
hitscope_test(panel_texture LABEL unit SOURCES ${CMAKE_CURRENT_LIST_DIR}/panel_texture_test.cpp LINK hitscope_mesh)
