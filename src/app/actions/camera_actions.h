// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <array>

#include "core/result.h"
#include "viewport/navigation.h"

class QAction;
class QMenu;
class QSettings;

namespace hitscope {

class AxisGizmo;
class CameraTrail;
class Viewport;

/// Everything about the camera that menus and keys offer: framing, views along an axis, the views before,
/// projection, what orbiting turns about, whose habits the mouse follows, bookmarks, and the camera as text.
class CameraActions : public QObject {
    Q_OBJECT
public:
    static constexpr int kBookmarks = 9;

    /// `viewport` outlives this.
    explicit CameraActions(Viewport& viewport, QObject* parent = nullptr);

    void fill(QMenu& menu);
    void fillEdit(QMenu& menu);                               ///< copy and paste
    [[nodiscard]] QAction* frame() const { return m_frame; }  ///< the selection; for a tool bar

    /// Remembered: preset, what orbiting turns about, projection, field of view, bookmarks.
    void load(const QSettings& settings);
    void save(QSettings& settings) const;

    /// Cameras as text, by their number; empty: none.
    using Bookmarks = std::array<QString, kBookmarks>;
    [[nodiscard]] const Bookmarks& bookmarks() const { return m_bookmarks; }
    void setBookmarks(const Bookmarks& bookmarks);  ///< texts that are no cameras are passed over
    [[nodiscard]] QString currentCamera() const;    ///< as text

    /// Takes the camera that the text describes; the error is parseCamera()'s.
    [[nodiscard]] Status paste(const QString& text);
    /// 0 <= index < kBookmarks.
    void store(int index);
    void recall(int index);

    [[nodiscard]] CameraTrail& trail() { return *m_trail; }

    bool eventFilter(QObject* watched, QEvent* event) override;

Q_SIGNALS:
    void said(const QString& text);  ///< worth a line in the status bar
    void failed(const hitscope::Error& error);
    void bookmarksChanged();

private:
    void fillViews(QMenu& menu);
    void fillTrail(QMenu& menu);
    void fillBookmarks(QMenu& menu);
    void fillFly(QMenu& menu);
    void follow();
    void followTrail();
    void followBookmarks();

    Viewport& m_viewport;
    Navigation& m_navigation;
    Bookmarks m_bookmarks;
    std::array<QAction*, kBookmarks> m_recall{};
    AxisGizmo* m_gizmo;
    CameraTrail* m_trail;
    QAction* m_frame = nullptr;
    QAction* m_back = nullptr;
    QAction* m_forward = nullptr;
    QAction* m_orthographic = nullptr;
    std::array<QAction*, kOrbitModes> m_orbitModes{};
    std::array<QAction*, kNavigationPresets> m_presets{};
};

}  // namespace hitscope
