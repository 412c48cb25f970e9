// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>
#include <cstddef>
#include <vector>

#include "view/camera.h"

namespace hitscope {

class Navigation;

/// The views that a camera came to rest at, to go back and forward through, as pages in a browser. Its own
/// history: what is undone in the session leaves the camera alone.
class CameraTrail : public QObject {
    Q_OBJECT
public:
    static constexpr std::size_t kMost = 200;  ///< views; the oldest are forgotten
    static constexpr int kRest = 600;          ///< milliseconds without a motion, after which a view counts

    /// `navigation` outlives this.
    explicit CameraTrail(Navigation& navigation, QObject* parent = nullptr);

    [[nodiscard]] bool canGoBack() const;
    [[nodiscard]] bool canGoForward() const { return m_at + 1 < m_views.size(); }
    void goBack();     ///< nothing where there is no view before
    void goForward();  ///< likewise
    /// The view now is one to come back to, if it is another than the last.
    void note();
    void clear();  ///< the views were of another scene

Q_SIGNALS:
    void changed();  ///< canGoBack() or canGoForward()

private:
    [[nodiscard]] bool isElsewhere() const;
    void go(std::size_t to);

    Navigation& m_navigation;
    QTimer m_rest;
    std::vector<Camera> m_views;
    std::size_t m_at = 0;  ///< index of the view that was noted or gone to last
};

}  // namespace hitscope
