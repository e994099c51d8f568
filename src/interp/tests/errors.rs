use super::{Options, SceneSource, debug, error, interpret, outcome};

#[test]
fn mistakes_are_errors() {
    for text in [
        "#declare A=Undeclared;",
        "#declare A=5 , 3",
        "#declare x=1;",
        "#declare sphere=1;",
        "#macro M(x) #end",
        "#declare A=<1>;",
        "#declare A=<1,2,3,4,5,6>;",
        "#declare A=<1,,2>;",
        "#declare A=<,1,2>;",
        "#declare A=1<2;",
        "#declare A=1.2.3;",
        "#declare A=sqrt(-1);",
        "#declare A=ln(0);",
        "#declare A=atan2(0,0);",
        "#declare A=pow(0,0);",
        "#declare A=substr(\"abc\",2,3)",
        "#declare A=chr(70000)",
        "#declare A=rand(3);",
        "#declare A=\"a\\q\"",
        "#declare A=array{1,2}",
        "#declare A=array[2]{1}",
        "#declare A=array[2]{1,2,3}",
        "#declare A=array[2]; #declare B=A[1];",
        "#declare A=array[2]; #declare A[2]=1;",
        "#declare A=array[2]; #declare A[0]=1; #declare A[1]=<1,2,3>;",
        "#declare V=<1,2>; #declare A=V.z;",
        "#declare V=<1,2,3>; #declare A=sin(V);",
        "#declare V=<1,2,3>; #declare V.x=3;",
        "#if (1)",
        "#end",
        "#else",
        "#case (1)",
        "#break",
        "#while (1) #break",
        "#switch (1) sphere { 0, 1 } #case (1) #end",
        "#for (I,1,2,0) #end",
        "#error \"stop\"",
        "#nonsense",
        "}",
        "foo",
        "/* open",
        "\"open",
        "#include \"no such file\"",
        "#version 3.0; #macro M() #end",
        "#declare A=(\"a\"+1);",
        "#fopen F \"/etc/passwd\" read",
        "#fopen F \"/etc/glint-test\" write",
    ] {
        error(text);
    }
}

#[test]
fn warnings_leave_a_value() {
    let cases = [
        ("#debug str(1/0,0,1)", "inf", "division by zero"),
        ("#debug str(-1/0,0,1)", "inf", "division by zero"),
        ("#debug str(acos(2),0,1)", "0.0", "not defined"),
        ("#debug vstr(3,vnormalize(0),\",\",0,0)", "0,0,0", "length 0"),
        ("#declare C=rgb <1,2,3,4>; #debug str(C.filter,0,0)", "4", "components"),
        ("#declare T=transform{scale <2,0,1>}", "", "scaling by 0"),
        ("#version 3.1; #declare A=5", "", "`;` is missing"),
    ];
    for (text, printed, warning) in cases {
        let outcome = outcome(text);
        assert!(outcome.scene.is_ok(), "{text}");
        assert_eq!(outcome.debug, printed, "{text}");
        assert!(outcome.warnings.iter().any(|w| w.message.contains(warning)), "{text}");
    }
}

#[test]
fn a_warning_repeated_at_one_spot_is_kept_once() {
    let outcome = outcome("#for (I,1,100) #declare A=1/0; #end");
    assert_eq!(outcome.warnings.iter().filter(|w| w.message.contains("division")).count(), 1);
}

#[test]
fn near_names_are_suggested() {
    let hint = |text| outcome(text).scene.unwrap_err().hint.unwrap_or_default();
    assert_eq!(hint("#declare Leaf=1; #declare A=Laef;"), "did you mean `Leaf`?");
    assert_eq!(hint("shpere { 0, 1 }"), "did you mean `sphere`?");
}

#[test]
fn errors_tell_the_calls_that_led_to_them() {
    let error = outcome("#macro Inner() Nothing #end #macro Outer() Inner() #end Outer()").scene.unwrap_err();
    let calls: Vec<&str> = error.trace.iter().map(|l| l.message.as_str()).collect();
    assert_eq!(calls, ["in macro `Inner`, called here", "in macro `Outer`, called here"]);
}

#[test]
fn deep_nesting_is_refused_not_overflowed() {
    for (open, close) in [("(", ")"), ("<1,", ">"), ("sin(", ")"), ("1?", ":1"), ("- ", ""), ("[", "]")] {
        let text = format!("#declare A={}1{};", open.repeat(100_000), close.repeat(100_000));
        error(&text);
    }
    assert_eq!(debug(&format!("#debug str({}1{},0,0)", "(".repeat(500), ")".repeat(500))), "1");
    error(&"#declare A=(1+".repeat(100_000));
    error(&"#if (1) ".repeat(100_000));
    error(&"#switch (1) #case (1) ".repeat(100_000));
    error(&"#switch (1) ".repeat(100_000));
}

#[test]
fn deprecated_names_warn_where_they_are_used() {
    let said = |text: &str| outcome(text).warnings.iter().filter(|w| w.message.contains("old")).count();
    assert_eq!(said("#declare deprecated once \"old\" X=3; #declare Y=X; #declare Z=X+X;"), 3);
    assert_eq!(said("#declare deprecated \"old\" X=3; #declare X=4; #declare Z=X;"), 0);
}

/// Where the reference helps nobody by refusing, a warning says what was assumed, unless it is to be refused.
#[test]
fn leniencies_are_warnings_or_errors() {
    for (text, printed, warning) in [
        ("#version 3.8; #debug str(version,0,2)", "3.70", "newer than 3.7"),
        ("#declare A=5 #debug str(A,0,0)", "5", "`;` is missing"),
        ("#declare V=<1,2,3>\n#debug str(V.y,0,0)", "2", "`;` is missing"),
        ("#declare C=rgb 1\nsphere{0,1} #debug str(C.red,0,0)", "1", "`;` is missing"),
        ("#for (K,1,2) #declare A=K #end #debug str(A,0,0)", "2", "`;` is missing"),
        ("#macro M() #local A=5 #debug str(A,0,0) #end M()", "5", "`;` is missing"),
    ] {
        let lenient = outcome(text);
        assert!(lenient.scene.is_ok(), "{text}");
        assert_eq!(lenient.debug, printed, "{text}");
        assert!(lenient.warnings.iter().any(|w| w.message.contains(warning)), "{text}");
        let source = SceneSource::Text { name: "test".to_owned(), text: text.as_bytes().to_vec() };
        let options = Options { start_version: Some(370), strict: true, ..Options::default() };
        assert!(interpret(source, &options).scene.unwrap_err().message.contains(warning), "{text}");
    }
}
