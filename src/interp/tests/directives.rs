use super::{debug, outcome, shown};

#[test]
fn conditionals_take_one_branch() {
    for (value, expected) in [("1", "if"), ("0", "else"), ("-1", "if"), ("1e-11", "else")] {
        assert_eq!(debug(&format!("#if ({value}) #debug \"if\" #else #debug \"else\" #end")), expected);
    }
    let chain = |v: u32| {
        debug(&format!(
            "#declare V={v}; #if (V=1) #debug \"1\" #elseif (V=2) #debug \"2\" #elseif (V=3) #debug \"3\" #else \
             #debug \"x\" #end"
        ))
    };
    assert_eq!((chain(1), chain(2), chain(3), chain(4)), ("1".into(), "2".into(), "3".into(), "x".into()));
}

#[test]
fn directives_may_stand_inside_expressions() {
    let text =
        "#declare Q=0; #declare V=<1, #if(Q) 2 #else 3 #end, 3>; #declare W=1+(#if(0) 5 #else 7 #end)*2;";
    assert_eq!(debug(&format!("{text}{}", shown(&["V.y", "W"]))), "3.000000 15.000000 ");
}

#[test]
fn skipped_text_may_hold_nested_blocks() {
    let text = "#if (0) #while(1) #if(1) } Unknown( /* #end */ \"#end\" #end #end #macro M() #end #else #debug \"ok\" #end";
    assert_eq!(debug(text), "ok");
}

#[test]
fn while_reads_its_condition_again() {
    assert_eq!(debug("#declare I=0; #while (I<3) #debug str(I,0,0) #declare I=I+1; #end"), "012");
    assert_eq!(debug("#while (0) #debug \"never\" #end #debug \"after\""), "after");
    let nested = "#declare I=0; #while (I<3) #declare J=0; #while (J<I) #debug concat(str(I,0,0),str(J,0,0),\" \") \
                  #declare J=J+1; #end #declare I=I+1; #end";
    assert_eq!(debug(nested), "10 20 21 ");
}

#[test]
fn for_counts_and_leaves_its_variable_behind() {
    assert_eq!(debug("#for (I,1,3) #debug str(I,0,0) #end #debug str(I,0,0)"), "1234");
    assert_eq!(debug("#for (I,0,0.3,0.1) #debug \".\" #end #debug str(I,0,1)"), "....0.4");
    assert_eq!(debug("#for (I,3,1,-1) #debug str(I,0,0) #end"), "321");
    assert_eq!(debug("#for (I,3,1) #debug \"never\" #end #debug str(I,0,0)"), "3");
    // The body may change the variable; `#break` keeps it.
    assert_eq!(debug("#for (I,1,9) #debug str(I,0,0) #declare I=I*2; #end #debug str(I,0,0)"), "13715");
    assert_eq!(debug("#for (I,1,9) #if (I=4) #break #end #end #debug str(I,0,0)"), "4");
}

#[test]
fn switch_falls_through_until_a_break() {
    let text = |v: &str| {
        format!(
            "#switch ({v}) #case (1) #debug \"1\" #case (2) #debug \"2\" #break #range (3,5) #debug \"r\" #break \
             #else #debug \"e\" #end #debug \".\""
        )
    };
    let cases = [("1", "12."), ("2", "2."), ("3", "r."), ("5", "r."), ("5.00000000001", "e."), ("0", "e.")];
    for (value, expected) in cases {
        assert_eq!(debug(&text(value)), expected, "{value}");
        // The same in kept text.
        assert_eq!(debug(&format!("#for (K,1,2) {} #end", text(value))), expected.repeat(2), "{value}");
    }
    // `#case` allows a small difference; text may stand in front of the first clause only as output.
    assert_eq!(debug("#switch (1.00000000001) #debug \"d\" #case (1) #debug \"1\" #end"), "d1");
}

#[test]
fn break_leaves_the_innermost_loop_clause_or_macro() {
    assert_eq!(debug("#while (1) #if (1) #if (1) #break #end #end #end #debug \"out\""), "out");
    let inner = "#for (I,1,2) #while (1) #debug \"w\" #break #end #end";
    assert_eq!(debug(inner), "ww");
    assert_eq!(debug("#macro M() #debug \"a\" #if (1) #break #end #debug \"b\" #end M() #debug \"c\""), "ac");
    assert_eq!(debug("#switch (1) #case (1) #if (1) #break #end #debug \"no\" #end #debug \"yes\""), "yes");
}

#[test]
fn ifdef_asks_for_any_name() {
    let text = "#declare A=array[3]; #declare A[1]=5; #macro M() #end ";
    for (name, expected) in
        [("A", "y"), ("A[1]", "y"), ("A[2]", "n"), ("B", "n"), ("x", "n"), ("M", "y"), ("frame_number", "y")]
    {
        let test = format!("{text} #ifdef ({name}) #debug \"y\" #else #debug \"n\" #end");
        assert_eq!(debug(&test), expected, "{name}");
        let test = format!("{text} #ifndef ({name}) #debug \"n\" #else #debug \"y\" #end");
        assert_eq!(debug(&test), expected, "{name}");
        let test = format!("{text} #if (defined({name})) #debug \"y\" #else #debug \"n\" #end");
        assert_eq!(debug(&test), expected, "{name}");
    }
}

#[test]
fn undef_removes_a_name() {
    let text = "#declare A=1; #undef A #ifdef (A) #debug \"y\" #else #debug \"n\" #end #undef A";
    let outcome = outcome(text);
    assert_eq!(outcome.debug, "n");
    assert!(outcome.warnings.iter().any(|w| w.message.contains("no value to remove")));
}

#[test]
fn long_output_is_cut() {
    let long = "concat(\"0123456789012345678901234567890123456789\",S,S,S,S)";
    let text = format!(
        "#declare S=\"0123456789012345678901234567890123456789\"; #debug {long} #debug concat({long},S)"
    );
    let out = debug(&text);
    assert_eq!(out.len(), 200 + 159);
    assert!(out.ends_with("..."));
}

#[test]
fn version_changes_what_is_read() {
    assert_eq!(
        debug("#debug str(version,0,2) #version 3.1; #declare A=5 #debug str(version+A,0,1)"),
        "3.708.1"
    );
}

#[test]
fn directives_wait_for_the_assignment_before_them() {
    let text = "#version 3.1; #declare A=5 #ifdef (A) #debug \"y\" #else #debug \"n\" #end";
    assert_eq!(debug(text), "y");
    let text =
        "#version 3.1; #macro M() #ifdef (A) #debug \"y\" #else #debug \"n\" #end #end #declare A=5 M()";
    assert_eq!(debug(text), "y");
}

#[test]
fn directives_may_choose_the_right_side() {
    let text =
        "#declare A = #ifdef (Foo) 4; #else 5; #end #declare S = #if (1) \"one\" #else \"two\" #end #debug S";
    assert_eq!(debug(&format!("{text}{}", shown(&["A"]))), "one5.000000 ");
}

#[test]
fn a_lone_hash_is_nothing() {
    let outcome = outcome("#debug \"a\" # #debug \"b\"");
    assert_eq!(outcome.debug, "ab");
}

/// Text skipped once is skipped in one step when the file is read again.
#[test]
fn files_read_again_skip_the_same_text() {
    let folder = std::env::temp_dir().join(format!("glint-skips-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let text = "#ifndef (Once) #declare Once=1; #debug \"first\" #else #if (Once=3) #debug \"three\" #elseif (Once=2) 
                #debug \"two\" #else #debug \"one\" #end #end #switch (Once) #case (2) #debug \"+\" #break #case (3) 
                #debug \"-\" #end";
    std::fs::write(folder.join("skips.inc"), text.replace("\\", "")).unwrap();
    let include = format!("#include \"{}/skips.inc\" ", folder.display());
    let scene = format!(
        "{include}{include}#declare Once=2; {include}#declare Once=3; {include}#undef Once {include}{include}"
    );
    let printed = debug(&scene);
    std::fs::remove_dir_all(&folder).unwrap();
    assert_eq!(printed, "firstonetwo+three-firstone");
}
