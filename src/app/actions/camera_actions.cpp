// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/actions/camera_actions.h"

#include <QActionGroup>
#include <QClipboard>
#include <QGuiApplication>
#include <QMenu>
#include <QMouseEvent>
#include <QSettings>
#include <utility>

#include "app/actions/menu_building.h"
#include "app/overlays/keys_lines.h"
#include "panels/help/help_text.h"
#include "view/camera_text.h"
#include "viewport/axis_gizmo.h"
#include "viewport/camera_trail.h"
#include "viewport/view_label.h"
#include "viewport/viewport.h"

namespace hitscope {

namespace {

/// A key of the number pad, and the one it is while NumLock is off.
QList<QKeySequence> padKeys(Qt::Key key, Qt::Key unlocked, Qt::KeyboardModifiers held = {}) {
    const Qt::KeyboardModifiers keys = held | Qt::KeypadModifier;
    return {QKeySequence(keys | key), QKeySequence(keys | unlocked)};
}

QList<QKeySequence> keysOf(StandardView view) {
    switch (view) {
        case StandardView::Front:
            return padKeys(Qt::Key_1, Qt::Key_End);
        case StandardView::Back:
            return padKeys(Qt::Key_1, Qt::Key_End, Qt::ControlModifier);
        case StandardView::Right:
            return padKeys(Qt::Key_3, Qt::Key_PageDown);
        case StandardView::Left:
            return padKeys(Qt::Key_3, Qt::Key_PageDown, Qt::ControlModifier);
        case StandardView::Top:
            return padKeys(Qt::Key_7, Qt::Key_Home);
        case StandardView::Bottom:
            break;
    }
    return padKeys(Qt::Key_7, Qt::Key_Home, Qt::ControlModifier);
}

QString bookmarkKey(int index) {
    return QStringLiteral("camera/bookmark%1").arg(index + 1);
}

QString textOf(const Camera& camera) {
    return QString::fromStdString(cameraText(camera));
}

/// A remembered choice among `count`; what it was if there is none.
template <class Enum>
Enum choice(const QSettings& settings, const QString& key, int count, Enum before) {
    bool isNumber = false;
    const int value = settings.value(key).toInt(&isNumber);
    return isNumber && value >= 0 && value < count ? static_cast<Enum>(value) : before;
}

template <class Act>
QAction* addWithKeys(QMenu& menu, const QString& text, const QList<QKeySequence>& keys, QObject* context,
                     Act act) {
    QAction* action = menu.addAction(text);
    action->setShortcuts(keys);
    QObject::connect(action, &QAction::triggered, context, std::move(act));
    return action;
}

}  // namespace

CameraActions::CameraActions(Viewport& viewport, QObject* parent)
    : QObject(parent),
      m_viewport(viewport),
      m_navigation(viewport.navigation()),
      m_gizmo(new AxisGizmo(m_navigation, &viewport)),
      m_trail(new CameraTrail(m_navigation, this)) {
    connect(&m_navigation, &Navigation::cameraChanged, this, &CameraActions::follow);
    connect(&m_navigation, &Navigation::settingsChanged, this, &CameraActions::follow);
    connect(&viewport.session(), &Session::sceneReplaced, m_trail, &CameraTrail::clear);
    viewport.installEventFilter(this);
}

/// A mouse's own buttons for back and forward.
bool CameraActions::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::MouseButtonPress) {
        const Qt::MouseButton button = static_cast<const QMouseEvent*>(event)->button();
        if (button == Qt::BackButton || button == Qt::ForwardButton) {
            button == Qt::BackButton ? m_trail->goBack() : m_trail->goForward();
            return true;
        }
    }
    return QObject::eventFilter(watched, event);
}

void CameraActions::fill(QMenu& menu) {
    m_frame = addAction(
        menu, tr("&Frame Selection"), Qt::Key_F, this, [this] { m_viewport.frameSelection(); },
        QStringLiteral("frame"));
    addWithKeys(menu, tr("Frame &All"), {QKeySequence(tr("Shift+F")), QKeySequence(Qt::Key_Home)}, this,
                [this] { m_viewport.frameAll(); });
    QMenu& camera = *menu.addMenu(tr("&Camera"));
    fillTrail(camera);
    fillViews(camera);
    fillFly(*camera.addMenu(tr("Fl&y")));
    camera.addSeparator();
    QMenu& about = *camera.addMenu(tr("Orbit Aro&und"));
    auto* abouts = new QActionGroup(this);
    const QString modes[] = {tr("&Point Under the Cursor"), tr("View &Centre"), tr("&Eye (Look Around)")};
    for (int mode = 0; mode < kOrbitModes; ++mode) {
        m_orbitModes[mode] = addWithKeys(about, modes[mode], {}, this, [this, mode] {
            m_navigation.setOrbitMode(static_cast<OrbitMode>(mode));
        });
        m_orbitModes[mode]->setCheckable(true);
        abouts->addAction(m_orbitModes[mode]);
    }
    QMenu& habits = *camera.addMenu(tr("&Mouse Buttons"));
    auto* presets = new QActionGroup(this);
    const QString names[] = {tr("As in &Hitscope: Left Orbits, Right Pans"),
                             tr("As in &Blender: Middle Orbits, Shift Pans, Ctrl Zooms")};
    for (int preset = 0; preset < kNavigationPresets; ++preset) {
        m_presets[preset] = addWithKeys(habits, names[preset], {}, this, [this, preset] {
            m_navigation.setPreset(static_cast<NavigationPreset>(preset));
        });
        m_presets[preset]->setCheckable(true);
        presets->addAction(m_presets[preset]);
    }
    fillBookmarks(*menu.addMenu(tr("Boo&kmarks")));
    follow();
}

void CameraActions::fillViews(QMenu& menu) {
    for (const StandardView view : kStandardViews) {
        m_gizmo->setAction(view, addWithKeys(menu, standardViewName(view), keysOf(view), this,
                                             [this, view] { m_navigation.show(view); }));
    }
    menu.addSeparator();
    m_orthographic =
        addWithKeys(menu, tr("&Orthographic"), padKeys(Qt::Key_5, Qt::Key_Clear), this, [this](bool on) {
            m_navigation.setProjection(on ? Projection::Orthographic : Projection::Perspective);
        });
    m_orthographic->setCheckable(true);
    menu.addSeparator();
}

void CameraActions::fillTrail(QMenu& menu) {
    m_back = addWithKeys(menu, tr("&Previous View"), {QKeySequence(Qt::ALT | Qt::Key_Left)}, this,
                         [this] { m_trail->goBack(); });
    m_forward = addWithKeys(menu, tr("&Next View"), {QKeySequence(Qt::ALT | Qt::Key_Right)}, this,
                            [this] { m_trail->goForward(); });
    m_back->setToolTip(tr("Where the camera was before"));
    m_forward->setToolTip(tr("Where the camera was before you went back"));
    connect(m_trail, &CameraTrail::changed, this, &CameraActions::followTrail);
    connect(&m_navigation, &Navigation::cameraChanged, this, &CameraActions::followTrail);
    followTrail();
    menu.addSeparator();
}

void CameraActions::followTrail() {
    enableIf(*m_back, m_trail->canGoBack(), tr("There is no view before this one."));
    enableIf(*m_forward, m_trail->canGoForward(), tr("You have not gone back."));
}

void CameraActions::fillFly(QMenu& menu) {
    const std::pair<QString, glm::vec3> steps[] = {
        {tr("Forward\tW"), {0.0f, 0.0f, 1.0f}}, {tr("Back\tS"), {0.0f, 0.0f, -1.0f}},
        {tr("Left\tA"), {-1.0f, 0.0f, 0.0f}},   {tr("Right\tD"), {1.0f, 0.0f, 0.0f}},
        {tr("Up\tE"), {0.0f, 1.0f, 0.0f}},      {tr("Down\tQ"), {0.0f, -1.0f, 0.0f}}};
    for (const auto& step : steps) {
        leaveOutOfKeys(
            *addWithKeys(menu, step.first, {}, this, [this, by = step.second] { m_navigation.flyStep(by); }));
    }
}

void CameraActions::fillBookmarks(QMenu& menu) {
    QMenu& keep = *menu.addMenu(tr("&Store"));
    menu.addSeparator();
    for (int index = 0; index < kBookmarks; ++index) {
        const auto key = static_cast<Qt::Key>(Qt::Key_1 + index);
        const QString name = tr("Bookmark &%1").arg(index + 1);
        QAction* storing = addWithKeys(keep, name, {QKeySequence(Qt::ControlModifier | key)}, this,
                                       [this, index] { store(index); });
        m_recall[index] =
            addWithKeys(menu, name, {QKeySequence(key)}, this, [this, index] { recall(index); });
        if (index > 0) {
            leaveOutOfKeys(*storing);
            leaveOutOfKeys(*m_recall[index]);
        } else {
            listKeysAs(*storing, tr("Ctrl+1 … 9"), tr("Store the camera as a bookmark"));
            listKeysAs(*m_recall[index], tr("1 … 9"), tr("Go to a bookmark"));
        }
    }
}

void CameraActions::fillEdit(QMenu& menu) {
    addWithKeys(menu, tr("Copy Ca&mera"), {QKeySequence(tr("Ctrl+Shift+C"))}, this, [this] {
        QGuiApplication::clipboard()->setText(textOf(m_navigation.goal()));
        Q_EMIT said(tr("Camera copied to the clipboard as text."));
    });
    addWithKeys(menu, tr("Paste Camer&a"), {QKeySequence(tr("Ctrl+Shift+V"))}, this, [this] {
        if (Status pasted = paste(QGuiApplication::clipboard()->text()); !pasted) {
            Q_EMIT failed(pasted.error());
        }
    });
}

Status CameraActions::paste(const QString& text) {
    Result<Camera> camera = parseCamera(text.toStdString(), m_navigation.camera());
    if (!camera) {
        return camera.error();
    }
    m_navigation.setCamera(camera.value());
    return Done{};
}

void CameraActions::store(int index) {
    m_bookmarks[index] = textOf(m_navigation.goal());
    followBookmarks();
    Q_EMIT said(tr("Bookmark %1 stored. Press %1 to return to it.").arg(index + 1));
}

void CameraActions::recall(int index) {
    if (m_bookmarks[index].isEmpty()) {
        Q_EMIT said(tr("Bookmark %1 is empty. Ctrl+%1 stores the camera there.").arg(index + 1));
    } else if (Status pasted = paste(m_bookmarks[index]); !pasted) {
        Q_EMIT failed(pasted.error());
    }
}

void CameraActions::follow() {
    m_orthographic->setChecked(m_navigation.goal().isOrthographic());
    m_orbitModes[static_cast<std::size_t>(m_navigation.orbitMode())]->setChecked(true);
    m_presets[static_cast<std::size_t>(m_navigation.preset())]->setChecked(true);
}

void CameraActions::followBookmarks() {
    for (int index = 0; index < kBookmarks; ++index) {
        m_recall[index]->setToolTip(m_bookmarks[index]);
    }
    Q_EMIT bookmarksChanged();
}

void CameraActions::load(const QSettings& settings) {
    m_navigation.setPreset(
        choice(settings, QStringLiteral("camera/preset"), kNavigationPresets, m_navigation.preset()));
    m_navigation.setOrbitMode(
        choice(settings, QStringLiteral("camera/orbit"), kOrbitModes, m_navigation.orbitMode()));
    Bookmarks bookmarks;
    for (int index = 0; index < kBookmarks; ++index) {
        bookmarks[index] = settings.value(bookmarkKey(index)).toString();
    }
    setBookmarks(bookmarks);
    Camera camera = m_navigation.camera();
    const QString last = settings.value(QStringLiteral("camera/last")).toString();
    if (const Result<Camera> read = parseCamera(last.toStdString(), camera)) {
        camera.setProjection(read.value().projectionKind());
        camera.setFieldOfView(read.value().fieldOfView());
        m_navigation.setCamera(camera, Navigation::Arrival::AtOnce);
    }
}

void CameraActions::setBookmarks(const Bookmarks& bookmarks) {
    for (int index = 0; index < kBookmarks; ++index) {
        m_bookmarks[index] = parseCamera(bookmarks[index].toStdString(), {}) ? bookmarks[index] : QString();
    }
    followBookmarks();
}

QString CameraActions::currentCamera() const {
    return textOf(m_navigation.goal());
}

void CameraActions::save(QSettings& settings) const {
    settings.setValue(QStringLiteral("camera/preset"), static_cast<int>(m_navigation.preset()));
    settings.setValue(QStringLiteral("camera/orbit"), static_cast<int>(m_navigation.orbitMode()));
    settings.setValue(QStringLiteral("camera/last"), textOf(m_navigation.goal()));
    for (int index = 0; index < kBookmarks; ++index) {
        if (m_bookmarks[index].isEmpty()) {
            settings.remove(bookmarkKey(index));
        } else {
            settings.setValue(bookmarkKey(index), m_bookmarks[index]);
        }
    }
}

}  // namespace hitscope
