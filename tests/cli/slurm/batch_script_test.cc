#include "cli/slurm/batch_script.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/input_error.h"
#include "cli/slurm/slurm.h"

namespace touchstone {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

TEST(BatchScript, WritesTheIndicesOfAnArrayAsRanges) {
  EXPECT_EQ(ArrayOf({3}), "3");
  EXPECT_EQ(ArrayOf({1, 2, 3}), "1-3");
  EXPECT_EQ(ArrayOf({1, 3, 4, 5, 9}), "1,3-5,9");
}

TEST(BatchScript, DropsOnlyTheOptionsOfSlurm) {
  EXPECT_THAT(
      WithoutSlurmOptions({"sweep", "contact", "--slurm", "--tasks", "4", "--seed", "4",
                           "--sbatch-args=--time=1", "--status", "--out", "a b"}),
      ElementsAre("sweep", "contact", "--seed", "4", "--out", "a b"));
  EXPECT_THAT(WithoutSlurmOptions({"--tasks=4", "--sbatch-args", "--slurm",
                                   "--slurm=true", "--status=true", "--quiet"}),
              ElementsAre("--quiet"));
}

TEST(BatchScript, SweepsTheShardOfItsTaskOnTheProcessorsThatSlurmGranted) {
  SlurmSweep sweep{.program = "/opt/touch stone",
                   .arguments = {"sweep", "contact", "--out", "a b"},
                   .folder = "a b",
                   .tasks = 8};
  EXPECT_THAT(ShardScript(sweep),
              HasSubstr("'/opt/touch stone' 'sweep' 'contact' '--out' 'a b' --jobs "
                        "\"${SLURM_CPUS_PER_TASK:-${SLURM_CPUS_ON_NODE:-1}}\" --shard "
                        "\"$SLURM_ARRAY_TASK_ID\"/8\n"));
  sweep.arguments.emplace_back("--jobs=3");
  EXPECT_THAT(ShardScript(sweep), Not(HasSubstr("SLURM_CPUS")));
  EXPECT_THAT(
      MergeScript(sweep),
      AllOf(
          HasSubstr("'/opt/touch stone' merge 'a b'/sweep.*-of-8.sqlite -o \"$part\"\n"),
          HasSubstr("exec mv \"$part\" 'a b'/sweep.sqlite\n")));
}

TEST(Slurm, ReadsItsQueue) {
  const auto queue = ParseQueue("12 3 RUNNING\n13 N/A PENDING\n");
  ASSERT_EQ(queue.size(), 2U);
  EXPECT_EQ(queue[0].job, "12");
  EXPECT_EQ(queue[0].index, 3U);
  EXPECT_EQ(queue[0].state, "RUNNING");
  EXPECT_EQ(queue[1].index, 0U);
  EXPECT_TRUE(ParseQueue("").empty());
}

TEST(Slurm, SplitsOptionsAsAShellWithoutRunningCommands) {
  EXPECT_THAT(WordsOf("--time=1 --comment='a b'"),
              ElementsAre("--time=1", "--comment=a b"));
  EXPECT_THROW(WordsOf("$(date)"), InputError);
  EXPECT_THROW(WordsOf("'open"), InputError);
}

}  // namespace
}  // namespace touchstone
