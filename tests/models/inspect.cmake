# SPDX-License-Identifier: GPL-3.0-or-later
hitscope_test(vertex_changes_model LABEL models SOURCES ${CMAKE_CURRENT_LIST_DIR}/vertex_changes_model_test.cpp
  LINK hitscope_models)
hitscope_test(attribution_model LABEL models SOURCES ${CMAKE_CURRENT_LIST_DIR}/attribution_model_test.cpp
  LINK hitscope_models)
