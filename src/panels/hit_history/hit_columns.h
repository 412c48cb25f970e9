// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QTableView;

namespace hitscope {

/// Widths that fit what the columns of a HitHistoryModel hold, and the few that are shown at first. From the
/// header's context menu each can be shown or hidden. Sizes are set by hand: measuring the contents of
/// 100,000 rows would cost time with every hit.
void setUpHitColumns(QTableView& table);

}  // namespace hitscope
