# SPDX-License-Identifier: GPL-3.0-or-later
hitscope_test(hit_history_tools LABEL widgets SOURCES hit_history_tools_test.cpp LINK hitscope_app TIMEOUT 300)
