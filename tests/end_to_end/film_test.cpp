// Films: whole or not at all, as a video where ffmpeg is installed, as pictures everywhere.
#include "tests/end_to_end/shell.hpp"

namespace graincrack::test {
namespace {

class Film : public testing::Test {
protected:
    void SetUp() override { shell_.must(make_disc + "disc.h5\ngraincrack-solve brazilian disc.h5 -o run.h5" + past_peak); }
    /// Skips what needs the program ffmpeg.
    [[nodiscard]] bool has_ffmpeg() const { return shell_.run("command -v ffmpeg ffprobe").exit_code == 0; }
    /// A program in place of ffmpeg, in the folder `instead`.
    void replace_ffmpeg(const std::string& lines) const {
        shell_.must("mkdir instead");
        write_text(shell_.file("instead/ffmpeg"), "#!/bin/sh\n" + lines);
        shell_.must("chmod +x instead/ffmpeg");
    }
    Shell shell_;
    const std::string film_ = "graincrack-post film run.h5 --size 640x480 --frames-per-second 4 ";
};

TEST_F(Film, IsAFolderOfPictures) {
    const Outcome outcome = shell_.run(film_ + "--duration 2s -o film");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(outcome.err, "");
    EXPECT_EQ(shell_.names(), "disc.h5\nfilm\nrun.h5\n");
    EXPECT_EQ(shell_.must("ls film | head -1; ls film | tail -1; ls film | wc -l"), "frame_0001.png\nframe_0008.png\n8\n");
    // Width and height in the header of each PNG; the first picture is another than the last.
    EXPECT_EQ(shell_.must("for each in film/*; do od -An -tx1 -j16 -N8 $each; done | sort -u"), " 00 00 02 80 00 00 01 e0\n");
    EXPECT_NE(content_of(shell_.file("film/frame_0001.png")), content_of(shell_.file("film/frame_0008.png")));
    // A shorter one in its place; the same with the same bytes.
    shell_.must("cp film/frame_0008.png last.png; " + film_ + "--duration 1s --quiet -o film/");
    EXPECT_EQ(shell_.must("ls film | wc -l; cmp film/frame_0004.png last.png"), "4\n");
    const Outcome by_time =
        shell_.run(film_ + "--by time --crack-mode sign --magnify 5 --title Disc --duration 1s --quiet -o by-time");
    EXPECT_EQ(by_time.exit_code, 0) << by_time.err;
    EXPECT_EQ(by_time.err, "");
}

TEST_F(Film, ReplacesNoFileAndNoFolderOfOthers) {
    shell_.must("mkdir folder; echo mine >folder/frame_1.png; echo mine >file");
    for (const char* name : {"folder", "folder/", "file"}) {
        const Outcome outcome = shell_.run(film_ + "--quiet -o " + name);
        EXPECT_EQ(outcome.exit_code, 5) << outcome.err;
        EXPECT_EQ(n_lines(outcome.err), 1) << outcome.err;
        EXPECT_NE(outcome.err.find(name), std::string::npos) << outcome.err;
    }
    if (has_ffmpeg()) {
        shell_.must("cp run.h5 film.mp4");
        const Outcome outcome = shell_.run(film_ + "--quiet -o film.mp4");
        EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
        EXPECT_NE(outcome.err.find("film.mp4: is a run"), std::string::npos) << outcome.err;
        shell_.must("cmp run.h5 film.mp4; rm film.mp4");
    }
    EXPECT_EQ(shell_.must("cat folder/frame_1.png file"), "mine\nmine\n");
    EXPECT_EQ(shell_.names(), "disc.h5\nfile\nfolder\nrun.h5\n");
}

TEST_F(Film, IsAVideo) {
    if (!has_ffmpeg()) GTEST_SKIP() << "ffmpeg is not installed";
    for (const std::string name : {"film.mp4", "film.webm"}) {
        const Outcome outcome = shell_.run(film_ + "--duration 2s -o " + name);
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        EXPECT_EQ(outcome.err, "");
        EXPECT_EQ(
            shell_.must("ffprobe -v error -count_frames -show_entries stream=width,height,pix_fmt,r_frame_rate,nb_read_frames "
                        "-of csv=p=0 " +
                        name),
            "640,480,yuv420p,4/1,8\n");
        const double duration = std::stod(shell_.must("ffprobe -v error -show_entries format=duration -of csv=p=0 " + name));
        EXPECT_NEAR(duration, 2, 0.01);
    }
    EXPECT_EQ(shell_.names(), "disc.h5\nfilm.mp4\nfilm.webm\nrun.h5\n");
    // moov before mdat: a player begins before it has all.
    EXPECT_EQ(shell_.must("grep -abo -e moov -e mdat film.mp4 | head -1 | cut -d: -f2"), "moov\n");
}

TEST_F(Film, AVideoNeedsFfmpeg) {
    const Outcome outcome = shell_.run("PATH=" GRAINCRACK_BIN " " + film_ + "--quiet -o film.mp4");
    EXPECT_EQ(outcome.exit_code, 5);
    EXPECT_EQ(
        outcome.err,
        "graincrack-post: film.mp4: there is no ffmpeg to make a video; name a folder for the pictures, or install ffmpeg\n");
    EXPECT_EQ(shell_.names(), "disc.h5\nrun.h5\n");
}

TEST_F(Film, OfAnEncoderThatFailsLeavesNothing) {
    replace_ffmpeg("echo 'no space' >&2; echo >&2; exit 9\n");
    write_text(shell_.file("film.mp4"), "earlier");
    const Outcome outcome = shell_.run("PATH=./instead:$PATH; " + film_ + "--quiet -o film.mp4");
    EXPECT_EQ(outcome.exit_code, 5);
    EXPECT_EQ(outcome.err, "graincrack-post: film.mp4: ffmpeg ended with exit code 9: no space\n");
    EXPECT_EQ(shell_.names(), "disc.h5\nfilm.mp4\ninstead\nrun.h5\n");
    EXPECT_EQ(content_of(shell_.file("film.mp4")), "earlier");
}

TEST_F(Film, ThatIsStoppedLeavesNothing) {
    replace_ffmpeg("exit 0\n");  // the test is that of a video too
    for (const std::string signal : {"INT", "TERM"}) {
        for (const std::string name : {"film", "film.mp4"}) {
            // bash starts what is in the background with SIGINT ignored.
            const Outcome stopped =
                shell_.run("PATH=./instead:$PATH\nenv --default-signal=INT " + film_ + "--duration 1h --quiet -o " + name +
                           " &\nfor ((i = 0; i < 500; ++i)); do ls | grep -q part && break; sleep 0.02; done\nls | grep -q part "
                           "|| echo 'no unfinished film seen'\nsleep 0.3; kill -" +
                           signal + " $!\nwait $!");
            EXPECT_EQ(stopped.exit_code, 128 + (signal == "INT" ? 2 : 15)) << stopped.err;
            EXPECT_EQ(stopped.out, "");
            EXPECT_EQ(n_lines(stopped.err), 1) << stopped.err;
            EXPECT_EQ(shell_.names(), "disc.h5\ninstead\nrun.h5\n");
        }
    }
}

TEST_F(Film, IsMadeOfACheckpointAndNotOfOneFrame) {
    const Outcome stopped = shell_.run(
        "graincrack-solve brazilian disc.h5 --material augig-granite --rate 0.001mm/s --quiet -o long.h5 &\n"
        "for ((i = 0; i < 500; ++i)); do [[ -e long.h5.part ]] && break; sleep 0.02; done\nsleep 2\nkill -TERM $!\n"
        "wait $!");
    EXPECT_EQ(stopped.exit_code, 128 + 15) << stopped.err;
    EXPECT_EQ(
        shell_.must("graincrack-post film long.h5.checkpoint --size 640x480 --duration 0.2s --quiet -o film; ls film | wc -l"),
        "5\n");
    shell_.must("graincrack-solve brazilian disc.h5 --frames 0 -o run.h5" + past_peak);
    const Outcome one = shell_.run(film_ + "-o other");
    EXPECT_EQ(one.exit_code, 3);
    EXPECT_EQ(n_lines(one.err), 1) << one.err;
    EXPECT_NE(one.err.find("run.h5: has frames of one time only; a film needs two at least"), std::string::npos) << one.err;
    EXPECT_EQ(shell_.names(), "disc.h5\nfilm\nlong.h5.checkpoint\nrun.h5\n");
}

}  // namespace
}  // namespace graincrack::test
