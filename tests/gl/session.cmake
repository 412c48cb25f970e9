# SPDX-License-Identifier: GPL-3.0-or-later
hitscope_test(scene_gpu LABEL gl SOURCES ${CMAKE_CURRENT_LIST_DIR}/scene_gpu_test.cpp LINK hitscope_session)
hitscope_test(determinism LABEL gl SOURCES ${CMAKE_CURRENT_LIST_DIR}/determinism_test.cpp LINK hitscope_session)
