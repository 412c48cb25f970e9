# SPDX-License-Identifier: GPL-3.0-or-later
hitscope_test(scene_panel LABEL widgets SOURCES scene_panel_test.cpp LINK hitscope_app TIMEOUT 300)
hitscope_test(scene_files LABEL widgets SOURCES scene_files_test.cpp LINK hitscope_app TIMEOUT 300)
