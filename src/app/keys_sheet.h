// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QWidget;

namespace hitscope {

/// Opens a sheet with every key and mouse button; stays open beside the window.
void showKeysSheet(QWidget* parent);

}  // namespace hitscope
