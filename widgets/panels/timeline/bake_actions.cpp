#include "widgets/panels/timeline/bake_actions.h"

#include "core/qt/session/motion/player.h"
#include "widgets/base/action_set.h"
#include "widgets/base/chooser.h"
#include "widgets/base/texts/core_text.h"
#include "widgets/base/theme/icons.h"
#include <QLocale>
#include <QMenu>
#include <QToolButton>

namespace ramure {

BakeActions::BakeActions(Document* document, Player* player, Chooser* chooser, ActionSet* set,
                         QObject* parent)
    : QObject(parent)
    , m_document(document)
    , m_player(player)
    , m_chooser(chooser)
    , m_set(set)
    , m_baker(document)
{
    set->add(this, {{"play.bake", Actions::tr("&Bake the motion"), "bake", noKeys,
                     Actions::tr("Compute all frames of the range and keep them beside the project; pulls "
                                 "and fallen apples are not kept"),
                     [this] { bake(); }},
                    {"play.freeBake", Actions::tr("F&ree the baked motion"), nullptr, noKeys,
                     Actions::tr("Delete the project's baked motion from the disk"), [this] { free(); }}});
    connect(&m_baker, &Baker::filesChanged, player, &Player::reloadBakes);
    connect(&m_baker, &Baker::filesChanged, this, &BakeActions::update);
    connect(m_baker.job(), &Job::runningChanged, this, &BakeActions::update);
    connect(m_baker.job(), &Job::finished, this, &BakeActions::finish);
    connect(player, &Player::bakeStateChanged, this, &BakeActions::update);
    connect(player, &Player::bakeRefused, this, [this](const Error& error) {
        complain(tr("Baked motion is not used: frames are computed when they are needed."), error);
    });
    connect(document, &Document::changed, this, [this](const Change& change) {
        if (change.has(changeReset))
            m_baker.job()->cancel(); // nobody waits for the motion of a project that was left
        if (change.has(changeFile | changeReset))
            update();
    });
    update();
}

void BakeActions::complain(const QString& what, const Error& error)
{
    m_chooser->report(Severity::Warning, QStringLiteral("%1\n%2").arg(what, errorTextWithPlace(error)));
}

/// A dialog of files out of the blue would leave the user wondering what is asked of them.
bool BakeActions::saveFirst()
{
    if (!m_save || !m_chooser->agrees(tr("Bake the motion"), tr("Save the project first?"),
                                      tr("Baked motion is kept in files beside the project file, so that it "
                                         "is there when the project is opened again. This project has no "
                                         "file yet."),
                                      tr("Save…")))
        return false;
    return m_save();
}

void BakeActions::bake()
{
    if (m_document->filePath().isEmpty() && !saveFirst())
        return;
    if (const auto started = m_baker.start(m_player->memoryLimit()); !started)
        complain(tr("The motion cannot be baked."), started.error());
}

void BakeActions::free()
{
    if (const auto freed = m_baker.remove(); !freed)
        complain(tr("Not all of the baked motion could be deleted."), freed.error());
    else
        emit messageRaised(tr("The baked motion is deleted"));
}

void BakeActions::finish(const std::optional<Error>& error)
{
    if (error && error->code == ErrorCode::Cancelled)
        emit messageRaised(tr("Baking was cancelled; no half-written file stays"));
    else if (error)
        complain(tr("The motion could not be baked."), *error);
    else
        emit messageRaised(
            tr("The motion is baked: %1 beside the project")
                .arg(QLocale().formattedDataSize(m_baker.bytes(), 1, QLocale::DataSizeTraditionalFormat)));
}

void BakeActions::fillMenu(QMenu* menu) const
{
    m_set->fill(menu, {"play.bake", "play.freeBake"});
}

QToolButton* BakeActions::makeButton(QWidget* parent)
{
    m_button = new QToolButton(parent);
    m_button->setObjectName(QStringLiteral("bakeButton"));
    m_button->setAutoRaise(true);
    m_button->setIconSize({16, 16});
    m_button->setFocusPolicy(Qt::TabFocus);
    m_button->setPopupMode(QToolButton::InstantPopup);
    auto* menu = new QMenu(m_button);
    fillMenu(menu);
    m_button->setMenu(menu);
    connect(m_button, &QObject::destroyed, this, [this] { m_button = nullptr; });
    update();
    return m_button;
}

void BakeActions::update()
{
    const BakeState state = m_player->bakeState();
    QAction* bake = m_set->find("play.bake");
    bake->setEnabled(!m_baker.job()->isRunning());
    m_set->find("play.freeBake")->setEnabled(state != BakeState::None);
    if (!m_button)
        return;
    m_button->setIcon(icon(state == BakeState::Good    ? "bake-good"
                           : state == BakeState::Stale ? "bake-stale"
                                                       : "bake"));
    QString tip = bake->toolTip();
    if (state == BakeState::Good)
        tip = tr("Baked: every frame of the range comes at once");
    if (state == BakeState::Stale)
        tip = tr("The baked motion is of another tree or of other parameters and is not used");
    m_button->setToolTip(tip);
    m_button->setAccessibleName(tip);
}

} // namespace ramure
