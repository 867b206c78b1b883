//! The texts of experiment files, whose heads are alike.

/// Makes the text of an experiment file: one group of meshes, under limits that suit every test.
macro_rules! experiment {
    ($name:literal, $task:literal, $meshes:literal, $($run:literal),+ $(,)?) => {
        concat!(
            "name = \"", $name, "\"\ntitle = \"Runs of a test\"\ntask = \"", $task, "\"\n",
            "seed = 3\n[limits]\ntimeout_seconds = 60\nmemory_gigabytes = 4\n",
            "[[group]]\nname = \"all\"\nmeshes = ", $meshes, "\n",
            $("[[group.run]]\n", $run, "\n"),+
        )
    };
}

pub(crate) use experiment;
