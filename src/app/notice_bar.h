// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <functional>

class QLabel;
class QPushButton;

namespace hitscope {

/// A bar over the top of another widget that says something worth knowing and does not stand in the way; it
/// stays until it is closed or cleared.
class NoticeBar : public QFrame {
    Q_OBJECT
public:
    explicit NoticeBar(QWidget* over);

    /// `offer`, if there is one, is a button that does `act` and closes the bar.
    void say(const QString& text, const QString& offer = {}, std::function<void()> act = {});
    void clear();
    [[nodiscard]] QString text() const;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void place();

    QLabel* m_text = nullptr;
    QPushButton* m_offer = nullptr;
    std::function<void()> m_act;
};

}  // namespace hitscope
