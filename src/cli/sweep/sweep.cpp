// SPDX-License-Identifier: GPL-3.0-or-later
// A grid of shoots: expanded into jobs, run here or elsewhere, merged into one table.
#include <signal.h>
#include <sys/prctl.h>

#include <QDir>
#include <QEventLoop>
#include <QFileInfo>
#include <QProcess>
#include <QTextStream>
#include <QThread>
#include <memory>
#include <set>

#include "cli/common_options.h"
#include "cli/progress_line.h"
#include "cli/standard_streams.h"
#include "cli/sweep/sweep_lists.h"
#include "cli/sweep/sweep_results.h"
#include "cli/verbs.h"
#include "io/staged_files.h"

namespace hitscope::cli {

namespace {

constexpr int kMostAtOnce = 1024;

/// Runs jobs as processes of this program, several at a time.
class LocalRun {
public:
    LocalRun(const std::vector<const SweepJob*>& jobs, QString folder, int atOnce)
        : m_jobs(jobs),
          m_folder(std::move(folder)),
          m_atOnce(atOnce),
          m_progress(QStringLiteral("Jobs"), static_cast<int>(jobs.size())) {}

    /// Until all are over. What failed is said; the worst of their statuses.
    int run() {
        for (int i = 0; i < m_atOnce; ++i) {
            startNext();
        }
        if (m_running > 0) {
            m_loop.exec();
        }
        return m_worst;
    }

private:
    void startNext() {
        if (m_next >= m_jobs.size()) {
            return;
        }
        const SweepJob& job = *m_jobs[m_next++];
        auto* const process = new QProcess(&m_loop);
        process->setStandardInputFile(QProcess::nullDevice());
        process->setStandardOutputFile(QProcess::nullDevice());
        process->setChildProcessModifier([] { ::prctl(PR_SET_PDEATHSIG, SIGTERM); });
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        if (m_atOnce > 1) {
            environment.insert(QStringLiteral("LP_NUM_THREADS"),
                               QStringLiteral("1"));  // processes share the cores
        }
        process->setProcessEnvironment(environment);
        QObject::connect(process, &QProcess::finished, process,
                         [this, process, &job](int status, QProcess::ExitStatus how) {
                             ended(*process, job, how == QProcess::NormalExit ? status : kSignalled);
                         });
        QObject::connect(process, &QProcess::errorOccurred, process,
                         [this, process, &job](QProcess::ProcessError error) {
                             if (error == QProcess::FailedToStart) {
                                 ended(*process, job, kBadInput);
                             }
                         });
        ++m_running;
        process->start(QCoreApplication::applicationFilePath(),
                       commandArguments(job, reportPathOf(m_folder, job)));
    }

    void ended(QProcess& process, const SweepJob& job, int status) {
        if (status > kDiffers) {
            m_progress.hide();
            const QString said = QString::fromUtf8(process.readAllStandardError()).trimmed();
            QTextStream(stderr) << "hitscope-cli: Job " << job.key
                                << " failed: " << (said.isEmpty() ? process.errorString() : said) << "\n";
            m_worst = std::max(m_worst, status == kCannotDraw ? kCannotDraw : kBadInput);
        }
        process.deleteLater();
        --m_running;
        m_progress.show(++m_done);
        startNext();
        if (m_running == 0) {
            m_loop.quit();
        }
    }

    const std::vector<const SweepJob*>& m_jobs;
    QString m_folder;
    int m_atOnce;
    ProgressLine m_progress;
    QEventLoop m_loop;
    std::size_t m_next = 0;
    int m_running = 0;
    int m_done = 0;
    int m_worst = kGood;
};

/// Jobs that have no result yet; of those that will have one in common, the first.
std::vector<const SweepJob*> jobsToDo(const SweepPlan& plan, const QString& folder) {
    std::vector<const SweepJob*> jobs;
    std::set<QString> seen;
    for (const SweepJob& job : plan.jobs) {
        if (seen.insert(job.key).second && !readResult(reportPathOf(folder, job))) {
            jobs.push_back(&job);
        }
    }
    return jobs;
}

Status printCommands(Invocation& given, const std::vector<const SweepJob*>& jobs, const QString& folder) {
    std::vector<SweepCommand> commands;
    QString list;
    for (const SweepJob* job : jobs) {
        const QString report = reportPathOf(folder, *job);
        commands.push_back({commandLine(given.text("program"), *job, report), report});
        list += commands.back().line + u'\n';
    }
    QTextStream(stdout) << (given.isSet("slurm")       ? slurmScript(commands, folder)
                            : given.isSet("snakemake") ? snakefile(commands)
                                                       : list);
    return Done{};
}

/// table.csv, table.json and plots.svg, of what there is.
Outcome merge(Invocation& given, const SweepPlan& plan, const QString& folder, int worst) {
    SweepTable table{plan, {}};
    std::size_t done = 0;
    bool areExact = true;
    for (const SweepJob& job : plan.jobs) {
        table.results.push_back(readResult(reportPathOf(folder, job)));
        done += table.results.back() ? 1 : 0;
        areExact = areExact && (!table.results.back() || table.results.back()->isExact);
    }
    const std::string json = toJson(table);
    for (const auto& [name, bytes] : {std::pair<const char*, std::string>{"table.csv", toCsv(table)},
                                      {"table.json", json},
                                      {"plots.svg", toSvg(table)}}) {
        if (Status written = writeWhole(folder + u'/' + QLatin1String(name), bytes); !written) {
            return written;
        }
    }
    QTextStream(stdout) << (given.isSet("json")
                                ? QString::fromStdString(json)
                                : QStringLiteral(
                                      "%1 of %2 have a result\nIn %3: table.csv, table.json, plots.svg\n")
                                      .arg(QString::number(done), counted(plan.jobs.size(), "job", "jobs"),
                                           QDir::toNativeSeparators(folder)));
    if (worst > kDiffers || done < plan.jobs.size()) {
        return Outcome(
            {counted(plan.jobs.size() - done, "job has", "jobs have").toStdString() + " no result.",
             given.file(0).toStdString(), "Start it again to run these alone."},
            worst > kDiffers ? worst : kBadInput);
    }
    return areExact ? Outcome(Done{})
                    : differs({"Some meshes are not what the reference makes of the hits.",
                               given.file(0).toStdString(), "The table's column \"exact\" says which."});
}

Outcome sweep(Invocation& given, int atOnce) {
    const QString path = given.file(0);
    const Result<QByteArray> json = readAllOf(path, qint64{64} << 20);
    if (!json) {
        return json.error();
    }
    const QString base = isStandardStream(path) ? QDir::currentPath() : QFileInfo(path).absolutePath();
    const Usage shoot = shootVerb().usage;
    const Result<SweepPlan> plan = readSweepPlan(json.value(), base, shoot);
    if (!plan) {
        return Error{plan.error().what,
                     path.toStdString() + (plan.error().where.empty() ? "" : ", " + plan.error().where), ""};
    }
    const QString folder = QDir(given.text("out")).absolutePath();
    const std::vector<const SweepJob*> jobs = jobsToDo(plan.value(), folder);
    if (!QDir().mkpath(folder + QStringLiteral("/jobs"))) {
        return Error{"The folder cannot be made.", folder.toStdString(), "Choose one you may write to."};
    }
    if (given.isSet("list") || given.isSet("slurm") || given.isSet("snakemake")) {
        return printCommands(given, jobs, folder);
    }
    const int worst = given.isSet("merge") ? kGood : LocalRun(jobs, folder, atOnce).run();
    return merge(given, plan.value(), folder, worst);
}

int runSweep(Invocation& given) {
    const int atOnce =
        given.isSet("jobs") ? given.wholeNumber("jobs", 1, kMostAtOnce) : QThread::idealThreadCount();
    int ways = 0;
    for (const char* way : {"list", "slurm", "snakemake", "merge"}) {
        ways += given.isSet(way) ? 1 : 0;
    }
    if (ways > 1) {
        given.complain(QStringLiteral("--list, --slurm, --snakemake and --merge exclude each other."));
    }
    return given.error().isEmpty() ? finish(sweep(given, atOnce)) : kWrongUsage;
}

}  // namespace

Verb sweepVerb() {
    return {
        {.name = QStringLiteral("sweep"),
         .files = QStringLiteral("PLAN"),
         .about = QStringLiteral("run a grid of shoots, here or on many machines, into one table"),
         .description = QStringLiteral(
             "A plan is JSON: {\"hitscope-sweep\": 1, \"scenes\": [\"a.obj\", \"b.obj\"], \"options\": "
             "{\"random\": 50, \"max-distance\": [0.3, 0.5], \"seed\": [1, 2, 3]}}. Its options are those of "
             "shoot; each combination is a job. Skips jobs that have a result, so an interrupted sweep "
             "resumes where it stopped. A result is valid for the content of its files, and of the "
             "meshes and buffers that these name; scenes of the same content share it. When no job is "
             "left to be run, writes table.csv, table.json and plots.svg of the results that there are; they "
             "do not depend on who ran the jobs. To use Slurm, pipe the output of --slurm into sbatch "
             "--wait, then write "
             "the table with --merge."),
         .options =
             {folderOption(
                  "out", QStringLiteral("Folder for the results; created if needed."),
                  QStringLiteral("hitscope-sweep"),
                  {QStringLiteral("table.csv"), QStringLiteral("table.json"), QStringLiteral("plots.svg")}),
              valueOption(
                  "jobs", "N",
                  QStringLiteral("Number of parallel jobs, 1 to 1024; default: one for each processor.")),
              flagOption("list", QStringLiteral("Run nothing; print one command line for each job "
                                                "without a result, for GNU parallel.")),
              flagOption("slurm", QStringLiteral("Run nothing; print a job array for sbatch.")),
              flagOption("snakemake", QStringLiteral("Run nothing; print a workflow for snakemake.")),
              flagOption("merge", QStringLiteral("Run nothing; write the table of the existing results.")),
              valueOption("program", "PATH", QStringLiteral("Program that the printed commands call."),
                          QStringLiteral("hitscope-cli")),
              flagOption("json", QStringLiteral("Print the table as JSON instead of text.")), quietOption()},
         .examples =
             {{QStringLiteral("Run a sweep on this machine."),
               QStringLiteral("hitscope-cli sweep plan.json --out results")},
              {QStringLiteral("Run the remaining jobs with GNU parallel (--sshlogin for other machines), "
                              "then write the table."),
               QStringLiteral("hitscope-cli sweep plan.json --out results --list | parallel && hitscope-cli "
                              "sweep plan.json --out results --merge")},
              {QStringLiteral("Do the same with snakemake."),
               QStringLiteral("hitscope-cli sweep plan.json --out flow --snakemake > Snakefile && snakemake "
                              "--cores 2 --quiet && hitscope-cli sweep plan.json --out flow --merge")}},
         .leastFiles = 1,
         .mostFiles = 1},
        runSweep};
}

}  // namespace hitscope::cli
