# SPDX-License-Identifier: GPL-3.0-or-later
hitscope_test(scene_model LABEL models SOURCES scene_model_test.cpp LINK hitscope_models)
hitscope_test(rotation_angles LABEL models SOURCES rotation_angles_test.cpp LINK hitscope_models)
