//! Options that POV-Ray knows and that change nothing here.

use super::settings::{Settings, boolean};
use super::table::{Kind, TABLE};

/// Keywords without effect, by the reason.
const WITHOUT_EFFECT: &[(&str, &[&str])] = &[
    (
        "there is no window",
        &[
            "Display",
            "Display_Gamma",
            "Pause_When_Done",
            "Palette",
            "Video_Mode",
            "Preview_Start_Size",
            "Preview_End_Size",
            "Draw_Vistas",
            "Real_Time_Raytracing",
        ],
    ),
    ("there is one measure of what is said", &["Verbose", "Warning_Level"]),
    (
        "it speeds up POV-Ray and changes no picture",
        &[
            "Bounding",
            "Bounding_Method",
            "Bounding_Threshold",
            "BSP_BaseAccessCost",
            "BSP_ChildAccessCost",
            "BSP_ISectCost",
            "BSP_MaxDepth",
            "BSP_MissChance",
            "Light_Buffer",
            "Max_Image_Buffer_Memory",
            "Remove_Bounds",
            "Split_Unions",
            "Vista_Buffer",
        ],
    ),
    (
        "the order of the blocks changes no picture",
        &["High_Reproducibility", "Render_Block_Step", "Render_Pattern"],
    ),
    ("Ctrl-C always stops", &["Test_Abort", "Test_Abort_Count"]),
    (
        "POV-Ray 3.7 itself does without it",
        &[
            "Buffer_Output",
            "Buffer_Size",
            "Clockless_Animation",
            "Create_Histogram",
            "Field_Render",
            "Histogram_Grid_Size",
            "Histogram_Name",
            "Histogram_Type",
            "Odd_Field",
        ],
    ),
    ("the pretrace shows nothing, and computes what it needs", &["Radiosity_Vain_Pretrace"]),
    (
        "rendering starts no programs",
        &[
            "Fatal_Error_Command",
            "Fatal_Error_Return",
            "Post_Frame_Command",
            "Post_Frame_Return",
            "Post_Scene_Command",
            "Post_Scene_Return",
            "Pre_Frame_Command",
            "Pre_Frame_Return",
            "Pre_Scene_Command",
            "Pre_Scene_Return",
            "User_Abort_Command",
            "User_Abort_Return",
        ],
    ),
];

/// Why a keyword has no effect, if it has none.
pub fn reason(keyword: &str) -> Option<&'static str> {
    WITHOUT_EFFECT.iter().find(|(_, keywords)| keywords.contains(&keyword)).map(|(reason, _)| *reason)
}

/// One note for each option that the user gave in vain.
pub fn of(settings: &Settings) -> Vec<String> {
    let mut notes = settings.remarks.clone();
    notes.extend(settings.given().filter_map(|(name, value)| in_vain(name, value)));
    let animated = ["Final_Frame", "Initial_Frame"].iter().any(|k| settings.int(k).unwrap_or(0) > 0);
    if settings.flag("Continue_Trace", false) && !animated {
        notes.push("Continue_Trace has no effect: a still picture is rendered from its beginning".to_owned());
    }
    if settings.given().any(|(name, value)| name == "Output_File_Type" && value.len() > 1) {
        notes.push(
            "only the first letter of Output_File_Type counts (N is PNG, P is PPM); Bits_Per_Color sets the \
             bits of a channel"
                .to_owned(),
        );
    }
    for (i, (name, _)) in settings.declares.iter().enumerate() {
        if settings.declares[..i].iter().any(|(earlier, _)| earlier == name) {
            notes.push(format!("Declare={name}: the first value given counts, as in POV-Ray"));
        }
    }
    notes
}

/// Switching something off that is not there is not in vain, nor switching messages on.
fn in_vain(name: &str, value: &str) -> Option<String> {
    let reason = reason(name)?;
    let switch = TABLE.keyword(name).is_some_and(|k| k.kind == Kind::Bool);
    if switch && boolean(value) == Some(name.ends_with("_Console")) {
        return None;
    }
    Some(format!("{name}={value} has no effect: {reason}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Keywords that are put to use.
    const USED: &[&str] = &[
        "All_Console",
        "Antialias",
        "Antialias_Depth",
        "Antialias_Gamma",
        "Antialias_Threshold",
        "Bits_Per_Color",
        "Bits_Per_Colour",
        "Clock",
        "Compression",
        "Continue_Trace",
        "Create_Ini",
        "Cyclic_Animation",
        "Declare",
        "Dither",
        "Dither_Method",
        "End_Column",
        "End_Row",
        "File_Gamma",
        "Final_Clock",
        "Final_Frame",
        "Frame_Step",
        "Grayscale_Output",
        "Height",
        "Include_Header",
        "Include_Ini",
        "Initial_Clock",
        "Initial_Frame",
        "Input_File_Name",
        "Jitter",
        "Jitter_Amount",
        "Library_Path",
        "Output_Alpha",
        "Output_File_Name",
        "Output_File_Type",
        "Output_To_File",
        "Quality",
        "Radiosity_File_Name",
        "Radiosity_From_File",
        "Radiosity_To_File",
        "Render_Block_Size",
        "Sampling_Method",
        "Start_Column",
        "Start_Row",
        "Subset_End_Frame",
        "Subset_Start_Frame",
        "Version",
        "Width",
        "Work_Threads",
        "All_File",
        "Append_File",
        "Debug_Console",
        "Debug_File",
        "Fatal_Console",
        "Fatal_File",
        "Render_Console",
        "Render_File",
        "Statistic_Console",
        "Statistic_File",
        "Warning_Console",
        "Warning_File",
    ];

    #[test]
    fn every_option_is_used_or_explained() {
        for keyword in &TABLE.keywords {
            let name = keyword.name;
            assert!(USED.contains(&name) != reason(name).is_some(), "{name}");
        }
        for (_, keywords) in WITHOUT_EFFECT {
            assert!(keywords.iter().all(|k| TABLE.keyword(k).is_some_and(|found| found.name == *k)));
        }
    }

    #[test]
    fn notes_are_about_what_the_user_gave() {
        let mut settings = Settings::default();
        settings.set("Display", "on").unwrap();
        settings.forget_who();
        for (keyword, value) in [
            ("Verbose", "off"),
            ("palette", "H"),
            ("Bounding_Method", "2"),
            ("Output_File_Type", "png"),
            ("Declare", "a=1"),
            ("Declare", "a=2"),
            ("Continue_Trace", "on"),
        ] {
            settings.set(keyword, value).unwrap();
        }
        let notes = of(&settings);
        let begins: Vec<_> = notes.iter().map(|n| n.split(' ').next().unwrap()).collect();
        assert_eq!(begins, ["Bounding_Method=2", "Palette=H", "Continue_Trace", "only", "Declare=a:"]);
    }
}
