# SPDX-License-Identifier: GPL-3.0-or-later
hitscope_test(hit_history LABEL models SOURCES hit_history_model_test.cpp LINK hitscope_models)
hitscope_test(mesh_statistics LABEL models SOURCES mesh_statistics_model_test.cpp LINK hitscope_models)
hitscope_test(constants_presets LABEL models SOURCES ${CMAKE_CURRENT_LIST_DIR}/constants_presets_test.cpp
  LINK hitscope_models)
