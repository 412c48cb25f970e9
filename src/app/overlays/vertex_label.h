// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>

#include "session/session.h"

namespace hitscope {

class Viewport;

/// A small label beside the cursor that says what the hovered vertex is: its number in the file, where it was
/// and is, how far it moved and its normal. Follows the hits.
class VertexLabel : public QLabel {
    Q_OBJECT
public:
    /// Both outlive the label.
    VertexLabel(Session& session, Viewport& viewport);

private:
    void follow();
    void place();
    [[nodiscard]] static QString describe(const Target& target, std::uint32_t vertex);

    Session& m_session;
    Viewport& m_viewport;
};

}  // namespace hitscope
