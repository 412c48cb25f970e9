# SPDX-License-Identifier: GPL-3.0-or-later
hitscope_test(lights_model LABEL models SOURCES ${CMAKE_CURRENT_LIST_DIR}/lights_model_test.cpp LINK hitscope_models)
