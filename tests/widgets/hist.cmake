# SPDX-License-Identifier: GPL-3.0-or-later
hitscope_test(hit_history LABEL widgets SOURCES hit_history_test.cpp LINK hitscope_app TIMEOUT 300)
hitscope_test(hit_menus LABEL widgets SOURCES hit_menus_test.cpp LINK hitscope_app TIMEOUT 300)
