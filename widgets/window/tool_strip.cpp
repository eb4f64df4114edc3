#include "widgets/window/tool_strip.h"

#include "widgets/base/fields/number_field.h"
#include "widgets/base/named.h"
#include "widgets/base/theme/icons.h"
#include "widgets/view/tools/hand_settings.h"
#include "widgets/view/view_settings.h"
#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QEvent>
#include <QFrame>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QScrollArea>
#include <QToolBar>
#include <QToolButton>
#include <algorithm>
#include <cmath>

namespace ramure {
namespace {

constexpr int stripIcon = 18, stripHeight = 36, leastTip = 120;

QString optionText(const char* english)
{
    return QCoreApplication::translate("HandOptions", english);
}

NumberFormat formatOf(const HandNumber& row)
{
    NumberFormat format{ParamUnit::None, row.scale, QString::fromLatin1(row.suffix), row.decimals};
    format.atZero = row.atZero ? optionText(row.atZero) : QString();
    return format;
}

NumberFormat formatOf(const HandCount& row)
{
    NumberFormat format{ParamUnit::None, 1.0, QString(), 0, true};
    format.atZero = row.atZero ? optionText(row.atZero) : QString();
    return format;
}

} // namespace

ToolStrip::ToolStrip(ViewSettings* settings, QList<QAction*> tools, QToolBar* transforms, QWidget* parent)
    : QWidget(parent)
    , m_settings(settings->hand())
    , m_tools(std::move(tools))
    , m_transforms(transforms)
    , m_icon(new QLabel(this))
    , m_name(named(new QLabel(this), "partTitle"))
    , m_tip(named(new QLabel(this), "dim"))
{
    setObjectName(QStringLiteral("toolStrip"));
    setAttribute(Qt::WA_StyledBackground);
    setFixedHeight(stripHeight);
    m_tip->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    m_tip->setTextFormat(Qt::PlainText);
    // The strip asks for no width: the window keeps its own.
    auto* scroll = new QScrollArea(this);
    auto* content = new QWidget(scroll);
    m_row = new QHBoxLayout(content);
    content->setFixedHeight(stripHeight); // else what wants more hangs lower than the rest
    m_row->setContentsMargins(10, 0, 10, 0);
    m_row->setSpacing(8);
    m_row->addWidget(m_icon);
    m_row->addWidget(m_name);
    m_row->addSpacing(6);
    m_row->addWidget(m_transforms);
    addChoices();
    addNumbers();
    addFlags();
    addMore();
    m_row->addWidget(m_more);
    m_row->addWidget(m_tip, 1);
    scroll->setWidget(content);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setFocusPolicy(Qt::NoFocus);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->viewport()->setAutoFillBackground(false);
    content->setAutoFillBackground(false);
    auto* whole = layoutOf<QHBoxLayout>(this);
    whole->addWidget(scroll);
    for (const QAction* tool : m_tools) {
        connect(tool, &QAction::toggled, this, &ToolStrip::follow);
        connect(tool, &QAction::changed, this, &ToolStrip::follow);
    }
    connect(m_settings, &HandSettings::toolChanged, this, &ToolStrip::follow);
    connect(m_settings, &HandSettings::optionsChanged, this, &ToolStrip::takeValues);
    follow();
    takeValues();
}

void ToolStrip::add(const Option& option, const char* id)
{
    option.widget->setObjectName(QLatin1String(id));
    option.widget->hide();
    option.widget->setToolTip(optionText(option.tip));
    option.widget->setAccessibleName(optionText(option.text));
    if (option.label) {
        option.label->setText(optionText(option.text));
        option.label->setBuddy(option.widget);
        option.label->hide();
    }
    m_options.push_back(option);
}

void ToolStrip::addNumbers()
{
    const auto field = [this](double least, double most, double step, const NumberFormat& format) {
        auto* made = new NumberField(this);
        made->setFormat(format);
        made->setRange(least, most);
        made->setStep(step);
        made->setScale(NumberScale(least, most, step, format.whole));
        made->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
        m_numbers.push_back(made);
        return made;
    };
    for (const HandNumber& row : handNumbers()) {
        NumberField* made = field(row.least, row.most, row.step, formatOf(row));
        connect(made, &NumberField::valueEdited, this, [this, member = row.member](double value) {
            HandOptions options = m_settings->options();
            options.*member = value;
            m_settings->setOptions(options);
        });
        auto* label = new QLabel(this);
        made->addHandle(label);
        add({row.tools, made, label, row.label, row.tip, row.where}, row.id);
    }
    for (const HandCount& row : handCounts()) {
        NumberField* made = field(row.least, row.most, 1.0, formatOf(row));
        connect(made, &NumberField::valueEdited, this, [this, member = row.member](double value) {
            HandOptions options = m_settings->options();
            options.*member = int(std::lround(value));
            m_settings->setOptions(options);
        });
        auto* label = new QLabel(this);
        made->addHandle(label);
        add({row.tools, made, label, row.label, row.tip}, row.id);
    }
}

void ToolStrip::addFlags()
{
    for (const HandFlag& row : handFlags()) {
        auto* box = new QCheckBox(optionText(row.label), this);
        box->setFocusPolicy(Qt::TabFocus); // a click leaves the keys with the view
        connect(box, &QCheckBox::toggled, this, [this, member = row.member](bool on) {
            HandOptions options = m_settings->options();
            options.*member = on;
            m_settings->setOptions(options);
        });
        add({row.tools, box, nullptr, row.label, row.tip}, row.id);
    }
}

void ToolStrip::addChoices()
{
    for (const HandChoice& row : handChoices()) {
        auto* box = new QComboBox(this);
        for (const auto& item : row.items)
            box->addItem(optionText(item));
        box->setSizeAdjustPolicy(QComboBox::AdjustToContents);
        box->setFocusPolicy(Qt::TabFocus);
        connect(box, &QComboBox::activated, this, [this, choose = row.choose](int item) {
            HandOptions options = m_settings->options();
            choose(options, item);
            m_settings->setOptions(options);
        });
        add({row.tools, box, new QLabel(this), row.label, row.tip}, row.id);
    }
}

void ToolStrip::addMore()
{
    m_more = named(new QToolButton(this), "moreOptions");
    m_more->setIcon(icon("more"));
    m_more->setIconSize({stripIcon, stripIcon});
    m_more->setAutoRaise(true);
    m_more->setFocusPolicy(Qt::TabFocus);
    m_more->setToolTip(tr("More options"));
    m_more->setAccessibleName(m_more->toolTip());
    m_more->hide();
    m_rest = named(new QFrame(this, Qt::Popup), "restOfOptions");
    m_restGrid = layoutOf<QGridLayout>(m_rest, -1, {12, 10, 12, 10});
    connect(m_more, &QToolButton::clicked, this, [this] {
        m_rest->adjustSize();
        const QPoint corner = m_more->mapToGlobal(m_more->rect().bottomRight());
        m_rest->move(corner.x() - m_rest->width(), corner.y() + 4);
        m_rest->show();
    });
}

void ToolStrip::takeValues()
{
    const HandOptions& options = m_settings->options();
    auto field = m_numbers.begin();
    for (const HandNumber& row : handNumbers())
        (*field++)->setValue(options.*row.member);
    for (const HandCount& row : handCounts())
        (*field++)->setValue(options.*row.member);
    for (const HandFlag& row : handFlags())
        findChild<QCheckBox*>(QLatin1String(row.id))->setChecked(options.*row.member);
    for (const HandChoice& row : handChoices())
        findChild<QComboBox*>(QLatin1String(row.id))->setCurrentIndex(row.chosen(options));
    place();
}

void ToolStrip::follow()
{
    const auto chosen = std::ranges::find_if(m_tools, &QAction::isChecked);
    if (chosen == m_tools.end())
        return; // on the way from one to another
    const QAction* tool = *chosen;
    m_icon->setPixmap(tool->icon().pixmap(QSize(stripIcon, stripIcon), devicePixelRatioF()));
    m_name->setText(tool->text().remove(u'&'));
    m_tipText = tool->statusTip();
    m_transforms->setVisible(m_settings->tool() == HandTool::None);
    place();
    elide();
}

void ToolStrip::place()
{
    const auto widthOf = [this](const QWidget* widget) {
        return widget->sizeHint().width() + m_row->spacing();
    };
    std::vector<const Option*> shown;
    std::vector<int> widths;
    int room = width() - m_row->contentsMargins().left() - m_row->contentsMargins().right() -
               widthOf(m_icon) - widthOf(m_name) - 2 * m_row->spacing();
    int all = 0;
    for (const Option& option : m_options)
        if ((option.tools & toolBit(m_settings->tool())) &&
            (!option.where || m_settings->options().*option.where)) {
            shown.push_back(&option);
            widths.push_back(widthOf(option.widget) + (option.label ? widthOf(option.label) : 0));
            all += widths.back();
        }
    std::size_t fit = shown.size();
    if (all > room) {
        room -= widthOf(m_more);
        for (fit = 0; fit < shown.size() && room >= widths[fit]; ++fit)
            room -= widths[fit];
    }
    const auto middle = shown.begin() + std::ptrdiff_t(fit);
    const std::vector<const Option*> inStrip(shown.begin(), middle), inRest(middle, shown.end());
    if (inStrip == m_inStrip && inRest == m_inRest)
        return;
    m_inStrip = inStrip;
    m_inRest = inRest;
    putOptions();
}

void ToolStrip::putOptions()
{
    m_rest->hide();
    for (const Option& option : m_options)
        for (QWidget* part : {static_cast<QWidget*>(option.label), option.widget})
            if (part) {
                part->hide();
                m_row->removeWidget(part);
                m_restGrid->removeWidget(part);
            }
    int at = m_row->indexOf(m_transforms) + 1, row = 0;
    for (const Option* option : m_inStrip) {
        if (option->label)
            m_row->insertWidget(at++, option->label);
        m_row->insertWidget(at++, option->widget);
    }
    for (const Option* option : m_inRest) {
        if (option->label)
            m_restGrid->addWidget(option->label, row, 0);
        m_restGrid->addWidget(option->widget, row++, 1);
    }
    for (const auto* options : {&m_inStrip, &m_inRest})
        for (const Option* option : *options) {
            option->widget->show();
            if (option->label)
                option->label->show();
        }
    m_more->setVisible(!m_inRest.empty());
    m_row->activate();
}

void ToolStrip::elide()
{
    const int room = m_tip->width();
    m_tip->setText(room < leastTip ? QString()
                                   : m_tip->fontMetrics().elidedText(m_tipText, Qt::ElideRight, room));
    m_tip->setToolTip(m_tip->text() == m_tipText ? QString() : m_tipText);
}

void ToolStrip::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    place();
    elide();
}

void ToolStrip::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange)
        follow();
}

} // namespace ramure
