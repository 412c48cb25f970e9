// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <functional>

class QLabel;
class QPushButton;

namespace hitscope {

/// A bar that says something worth knowing. It stays until it is closed or cleared; then it takes no room.
class NoticeBar : public QFrame {
    Q_OBJECT
public:
    explicit NoticeBar(QWidget* parent = nullptr);

    /// `offer`, if there is one, is a button that does `act` and closes the bar. Returns the number of the
    /// notice.
    int say(const QString& text, const QString& offer = {}, std::function<void()> act = {});
    void clear();
    [[nodiscard]] bool isSaying(int notice) const { return notice == m_notice && !text().isEmpty(); }
    [[nodiscard]] QString text() const;

private:
    QLabel* m_text = nullptr;
    QPushButton* m_offer = nullptr;
    std::function<void()> m_act;
    int m_notice = 0;  ///< number of the last one
};

}  // namespace hitscope
