# SPDX-License-Identifier: GPL-3.0-or-later
hitscope_test(undo_text LABEL models SOURCES undo_text_test.cpp LINK hitscope_models)
