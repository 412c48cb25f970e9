// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures and sequences as files, from the window.
#include <QApplication>
#include <QComboBox>
#include <QDir>
#include <QImage>
#include <QImageReader>
#include <QMessageBox>
#include <QProgressDialog>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QStandardPaths>
#include <algorithm>
#include <functional>
#include <utility>

#include "analysis/change_values.h"
#include "app/actions/picture_actions.h"
#include "app/dialogs/picture_dialog.h"
#include "mesh/primitives.h"
#include "panels/change/change_panel.h"
#include "session/vertex_selection.h"
#include "support/baseline.h"
#include "support/test_program.h"
#include "widgets/window_support.h"

namespace hitscope::pictures_test {

class PicturesTest : public QObject, protected WindowFixture {
    Q_OBJECT
public:
    static void initMain() { MainWindow::setSurfaceFormat(); }

private Q_SLOTS:
    void init();
    void cleanup();
    void suffixTellsTheFormat();
    void saveKeyAsksNothing();
    void anySizeAndTransparent();
    void selectionMarksAreLeftOut();
    void tooLargeSaysTheLimit();
    void folderThatIsNotThere();
    void turntableGoesOnceAround();
    void replayShowsHitsOneByOne();
    void sequenceEndsOnce();
    void replayIsColoured_data();
    void replayIsColoured();
    void coloursAreThoseShown();
    void labelsAreThoseOfTheViewport();
    void twoPipelinesAreInOnePicture();
    void sequenceCanBeCancelled();
    void sequenceGivesEventsTheirTurn();
    void dialogRemembers();

private:
    [[nodiscard]] PictureActions& pictures() { return *m_window->findChild<PictureActions*>(); }
    [[nodiscard]] QString path(const QString& name) const { return m_folder->filePath(name); }
    [[nodiscard]] PictureRequest request(int width, int height);
    [[nodiscard]] QStringList files() const {
        return QDir(m_folder->path()).entryList({QStringLiteral("*.png")}, QDir::Files, QDir::Name);
    }
    void addHits();
    void colourBy(ChangeQuantity quantity) {
        auto* panel = m_window->findChild<ChangePanel*>();
        auto* box = panel->findChild<QComboBox*>(QStringLiteral("quantity"));
        QTest::keyClick(&m_window->viewport(), Qt::Key_V);
        Q_EMIT box->activated(static_cast<int>(quantity));
        QVERIFY(m_window->viewport().options().change.on);
        QCOMPARE(m_window->viewport().options().change.quantity, quantity);
    }
    [[nodiscard]] QImage saved(const PictureRequest& request) {
        const QString file = path(QStringLiteral("saved.png"));
        return pictures().save(request, file).ok() ? QImage(file) : QImage();
    }

    std::unique_ptr<QTemporaryDir> m_folder;
};

void PicturesTest::init() {
    m_folder = std::make_unique<QTemporaryDir>();
    makeWindow();
}

void PicturesTest::cleanup() {
    dropWindow();
    m_folder.reset();
}

PictureRequest PicturesTest::request(int width, int height) {
    PictureRequest request = m_window->viewport().pictureRequest();
    request.width = width;
    request.height = height;
    return request;
}

void PicturesTest::addHits() {
    const TargetId target = m_session->targets().front()->id;
    const glm::vec3 toEye = -m_window->viewport().camera().forward();
    for (const float aside : {-0.5f, 0.0f, 0.5f}) {
        const glm::vec3 out = glm::normalize(toEye + aside * m_window->viewport().camera().right());
        Hit hit;
        hit.target = target;
        hit.point = 2.5f * out;
        hit.direction = -out;
        QVERIFY(m_session->hits().add(hit).ok());
    }
}

void PicturesTest::saveKeyAsksNothing() {
    QSettings().setValue(QStringLiteral("picture/folder"), m_folder->path());
    QTest::keyClick(&m_window->viewport(), Qt::Key_F12);
    QTest::keyClick(&m_window->viewport(), Qt::Key_F12);
    QCOMPARE(files().size(), 2);
    const QImage picture(path(files().front()));
    QCOMPARE(picture.size(), m_window->viewport().size() * m_window->viewport().devicePixelRatioF());
    // It is what the viewport shows.
    QImage shown = m_window->viewport().surface().grab().convertToFormat(QImage::Format_RGB32);
    QCOMPARE(picture.pixel(picture.width() / 2, picture.height() / 2) | 0xff000000u,
             shown.pixel(shown.width() / 2, shown.height() / 2));
}

void PicturesTest::selectionMarksAreLeftOut() {
    addHits();
    const QImage plain = saved(request(320, 240));
    const QImage shown = m_window->viewport().surface().grab();
    m_session->hits().select(1);
    m_session->selection().select(m_session->targets().front()->id, {10, 20, 30},
                                  VertexSelection::Combine::Replace);
    m_session->selection().setPicked(VertexRef{m_session->targets().front()->id, 10});
    QCOMPARE(saved(request(320, 240)), plain);
    PictureRequest marked = request(320, 240);
    marked.selectionMarks = true;
    QVERIFY(saved(marked) != plain);
    QVERIFY(m_window->viewport().surface().grab() != shown);
    // Esc takes the ring away as well, and the vertices.
    QTest::keyClick(&m_window->viewport(), Qt::Key_Escape);
    QVERIFY(!m_session->hits().selected());
    QCOMPARE(m_window->viewport().surface().grab(), shown);
}

void PicturesTest::anySizeAndTransparent() {
    PictureRequest large = request(3000, 500);
    large.options.transparent = true;
    large.options.floor = false;
    QVERIFY(pictures().save(large, path(QStringLiteral("large.png"))).ok());
    const QImage picture(path(QStringLiteral("large.png")));
    QCOMPARE(picture.size(), QSize(3000, 500));
    QCOMPARE(qAlpha(picture.pixel(2, 2)), 0);
    QCOMPARE(qAlpha(picture.pixel(1500, 250)), 255);
    QVERIFY(qGreen(picture.pixel(1500, 250)) > 20);
    // Without it, nothing can be seen through.
    large.options.transparent = false;
    QVERIFY(pictures().save(large, path(QStringLiteral("large.png"))).ok());
    QCOMPARE(qAlpha(QImage(path(QStringLiteral("large.png"))).pixel(2, 2)), 255);
}

void PicturesTest::tooLargeSaysTheLimit() {
    const Status saved = pictures().save(request(1'000'000, 10), path(QStringLiteral("huge.png")));
    QVERIFY(!saved.ok());
    QVERIFY(saved.error().what.find("1000000 x 10") != std::string::npos);
    QVERIFY(files().isEmpty());
    QVERIFY(!pictures().save(request(0, 10), path(QStringLiteral("none.png"))).ok());
}

void PicturesTest::folderThatIsNotThere() {
    const QString nowhere = path(QStringLiteral("no/such/folder.png"));
    const Status saved = pictures().save(nowhere);
    QVERIFY(!saved.ok());
    QVERIFY(QString::fromStdString(saved.error().message()).contains(nowhere));
}

void PicturesTest::turntableGoesOnceAround() {
    addHits();  // a bare sphere looks the same from all sides
    const Camera before = m_window->viewport().camera();
    const QSignalSpy ended(&pictures().sequences(), &SequenceWriter::ended);
    pictures().writeSequence({request(160, 120), 4, m_folder->path(), QStringLiteral("turn")});
    QVERIFY(m_window->findChild<QProgressDialog*>() != nullptr);
    QTRY_COMPARE_WITH_TIMEOUT(ended.size(), 1, kPatience);
    QCOMPARE(files(), (QStringList{QStringLiteral("turn-0001.png"), QStringLiteral("turn-0002.png"),
                                   QStringLiteral("turn-0003.png"), QStringLiteral("turn-0004.png")}));
    QVERIFY(QImage(path(files()[0])) != QImage(path(files()[2])));
    QVERIFY(m_window->viewport().camera() == before);
}

void PicturesTest::replayShowsHitsOneByOne() {
    addHits();
    const std::size_t disabled[] = {1};
    m_session->hits().setEnabled(disabled, false);
    const std::uint64_t revision = m_session->hits().history().revision();
    const QSignalSpy ended(&pictures().sequences(), &SequenceWriter::ended);
    pictures().writeSequence({request(160, 120), 0, m_folder->path(), QStringLiteral("replay")});
    QTRY_COMPARE_WITH_TIMEOUT(ended.size(), 1, kPatience);
    QCOMPARE(files().size(), 3);  // before, and after each of two
    QVERIFY(QImage(path(files()[0])) != QImage(path(files()[1])));
    QVERIFY(QImage(path(files()[1])) != QImage(path(files()[2])));
    QCOMPARE(m_session->hits().history().revision(), revision);  // the session was left alone
    // The last one is what the viewport shows.
    QCOMPARE(saved(request(160, 120)), QImage(path(QStringLiteral("replay-0003.png"))));
}

/// A dialog that shows progress handles events: pictures may arrive while another is told of.
void PicturesTest::sequenceEndsOnce() {
    addHits();
    const QSignalSpy ended(&pictures().sequences(), &SequenceWriter::ended);
    bool isFirst = true;
    connect(&pictures().sequences(), &SequenceWriter::progressed, this, [&] {
        if (std::exchange(isFirst, false)) {
            QTRY_VERIFY_WITH_TIMEOUT(!ended.isEmpty(), kPatience);
        }
    });
    pictures().writeSequence({request(160, 120), 4, m_folder->path(), QStringLiteral("turn")});
    QTRY_VERIFY_WITH_TIMEOUT(!ended.isEmpty(), kPatience);
    QCoreApplication::processEvents();
    QCOMPARE(ended.size(), 1);
    QCOMPARE(files().size(), 4);
}

void PicturesTest::replayIsColoured_data() {
    QTest::addColumn<ChangeQuantity>("quantity");
    QTest::newRow("displacement") << ChangeQuantity::Displacement;
    QTest::newRow("edge stretch") << ChangeQuantity::EdgeStretch;
    QTest::newRow("hits") << ChangeQuantity::HitCount;
}

void PicturesTest::replayIsColoured() {
    QFETCH(ChangeQuantity, quantity);
    colourBy(quantity);
    addHits();
    QVERIFY(m_window->viewport().syncNow().ok());
    const ChangeValues& values = *request(1, 1).changeValues;
    QTRY_VERIFY_WITH_TIMEOUT(values.isComplete() && values.summary().high > 0.0, kPatience);
    const QSignalSpy ended(&pictures().sequences(), &SequenceWriter::ended);
    pictures().writeSequence({request(160, 120), 0, m_folder->path(), QStringLiteral("replay")});
    QTRY_COMPARE_WITH_TIMEOUT(ended.size(), 1, kPatience);
    // Over the range that was shown when it began, and so in the end as it is shown.
    QCOMPARE(saved(request(160, 120)), QImage(path(QStringLiteral("replay-0004.png"))));
    QVERIFY(QImage(path(QStringLiteral("replay-0004.png"))) !=
            QImage(path(QStringLiteral("replay-0003.png"))));
}

void PicturesTest::coloursAreThoseShown() {
    addHits();
    colourBy(ChangeQuantity::Displacement);
    PictureRequest map = request(160, 120);
    QuantityStyle& style = map.options.change.style();
    QVERIFY(style.automatic);
    const QImage automatic = saved(map);
    style.automatic = false;
    QVERIFY(saved(map) != automatic);
    style.fixed = shownRange(m_window->viewport().options().change, map.changeValues->summary());
    QCOMPARE(saved(map), automatic);
}

void PicturesTest::labelsAreThoseOfTheViewport() {
    addHits();
    colourBy(ChangeQuantity::Displacement);
    const QSize size = m_window->viewport().size();
    PictureRequest shown = request(size.width(), size.height());
    QVERIFY(shown.labels);
    const QImage picture = saved(shown);
    const QImage viewport = m_window->viewport().surface().grab();
    const QRect corner(0, size.height() - 250, 120, 250);
    const int most = corner.width() * corner.height() / 100;  // smoothed edges
    QVERIFY(test::differing(picture.copy(corner), viewport.copy(corner), 8) < most);
    shown.labels = false;
    QVERIFY(test::differing(saved(shown).copy(corner), viewport.copy(corner), 8) > 10 * most);
}

void PicturesTest::twoPipelinesAreInOnePicture() {
    addHits();
    const QImage one = saved(request(320, 120));
    QTest::keyClick(&m_window->viewport(), Qt::Key_B, Qt::ShiftModifier);
    QVERIFY(m_window->viewport().options().sideBySide);
    PictureRequest both = request(320, 120);
    both.labels = false;
    const QImage two = saved(both);
    QVERIFY(two != one);
    QCOMPARE(test::differing(two.copy(0, 0, 160, 120), two.copy(160, 0, 160, 120), 1), 0);
}

void PicturesTest::sequenceCanBeCancelled() {
    const QSignalSpy ended(&pictures().sequences(), &SequenceWriter::ended);
    pictures().writeSequence({request(320, 240), 5000, m_folder->path(), QStringLiteral("turn")});
    QTRY_VERIFY_WITH_TIMEOUT(files().size() >= 2, kPatience);
    auto* progress = m_window->findChild<QProgressDialog*>();
    QTest::mouseClick(progress->findChild<QPushButton*>(), Qt::LeftButton);
    QVERIFY(!pictures().sequences().isRunning());
    QTRY_COMPARE_WITH_TIMEOUT(ended.size(), 1, kPatience);  // once those that are drawn are written
    QCOMPARE(files().size(), static_cast<qsizetype>(ended[0][0].toInt()));
}

/// However many pictures are written already.
void PicturesTest::sequenceGivesEventsTheirTurn() {
    SequenceWriter writer(m_window->viewport());
    const QSignalSpy ended(&writer, &SequenceWriter::ended);
    int steps = 0;
    int most = 0;
    connect(&writer, &SequenceWriter::sampled, this, [&] { most = std::max(most, ++steps); });
    const std::function<void()> turn = [&] {
        steps = 0;
        if (ended.isEmpty()) {
            QMetaObject::invokeMethod(&writer, turn, Qt::QueuedConnection);
        }
    };
    PictureRequest small = request(32, 24);
    small.samples = 16;
    QVERIFY(writer.start({small, 24, m_folder->path(), QStringLiteral("turn")}).ok());
    turn();
    QTRY_COMPARE_WITH_TIMEOUT(ended.size(), 1, kPatience);
    QCOMPARE(files().size(), 24);
    // One late in a turn, and one early in the next.
    QVERIFY2(most >= 1 && most <= 2, qPrintable(QString::number(most)));
}

void PicturesTest::dialogRemembers() {
    QSettings settings;
    {
        PictureDialog dialog(PictureDialog::Kind::Sequence, {800, 600}, 3);
        QCOMPARE(dialog.pictureSize(), QSize(800, 600));
        dialog.findChild<QSpinBox*>(QStringLiteral("pictureWidth"))->setValue(1920);
        dialog.findChild<QSpinBox*>(QStringLiteral("pictureHeight"))->setValue(1080);
        dialog.findChild<QAbstractButton*>(QStringLiteral("transparent"))->setChecked(true);
        QVERIFY(dialog.turntable() > 0);
        dialog.findChild<QAbstractButton*>(QStringLiteral("replay"))->click();
        QCOMPARE(dialog.turntable(), 0);
        dialog.findChild<QAbstractButton*>(QStringLiteral("turntable"))->click();
        QVERIFY(dialog.turntable() > 0);
        dialog.save(settings);
    }
    PictureDialog dialog(PictureDialog::Kind::Picture, {640, 480}, 0);
    dialog.load(settings);
    QCOMPARE(dialog.pictureSize(), QSize(1920, 1080));
    QVERIFY(dialog.isTransparent());
}

void PicturesTest::suffixTellsTheFormat() {
    const QString jpeg = path(QStringLiteral("a.jpg"));
    QVERIFY(pictures().save(request(96, 64), jpeg).ok());
    QCOMPARE(QImageReader::imageFormat(jpeg), QByteArray("jpeg"));
    const Status saved = pictures().save(request(96, 64), path(QStringLiteral("a.psd")));
    QVERIFY(!saved && saved.error().advice.find(".png, .jpg") != std::string::npos);
    PictureRequest open = request(96, 64);
    open.options.transparent = true;
    QVERIFY(!pictures().save(open, path(QStringLiteral("b.jpg"))).ok());
    QVERIFY(!QFile::exists(path(QStringLiteral("b.jpg"))));
}

HITSCOPE_TEST(PicturesTest, QApplication)

}  // namespace hitscope::pictures_test

#include "pictures_test.moc"
