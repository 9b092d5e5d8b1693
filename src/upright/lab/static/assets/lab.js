const lg="uplot",cg="u-hz",hg="u-vt",ug="u-title",dg="u-wrap",fg="u-under",pg="u-over",mg="u-axis",Ds="u-off",gg="u-select",_g="u-cursor-x",vg="u-cursor-y",xg="u-cursor-pt",bg="u-legend",yg="u-live",Mg="u-inline",Sg="u-series",wg="u-marker",fu="u-label",Eg="u-value",ur="width",dr="height";const pu="bottom",oo="left",hl="right",rh="#000",mu=rh+"0",ul="mousemove",gu="mousedown",dl="mouseup",_u="mouseenter",vu="mouseleave",xu="dblclick",Tg="resize",Ag="scroll",bu="change",Ta="dppxchange",ah="--",Go=typeof window<"u",tc=Go?document:null,To=Go?window:null,Rg=Go?navigator:null;let St,zr;function nc(){let i=devicePixelRatio;St!=i&&(St=i,zr&&sc(bu,zr,nc),zr=matchMedia(`(min-resolution: ${St-.001}dppx) and (max-resolution: ${St+.001}dppx)`),Bs(bu,zr,nc),To.dispatchEvent(new CustomEvent(Ta)))}function Fn(i,e){if(e!=null){let t=i.classList;!t.contains(e)&&t.add(e)}}function ic(i,e){let t=i.classList;t.contains(e)&&t.remove(e)}function kt(i,e,t){i.style[e]=t+"px"}function ii(i,e,t,n){let s=tc.createElement(i);return e!=null&&Fn(s,e),t?.insertBefore(s,n),s}function qn(i,e){return ii("div",i,e)}const yu=new WeakMap;function _i(i,e,t,n,s){let o="translate("+e+"px,"+t+"px)",r=yu.get(i);o!=r&&(i.style.transform=o,yu.set(i,o),e<0||t<0||e>n||t>s?Fn(i,Ds):ic(i,Ds))}const Mu=new WeakMap;function Su(i,e,t){let n=e+t,s=Mu.get(i);n!=s&&(Mu.set(i,n),i.style.background=e,i.style.borderColor=t)}const wu=new WeakMap;function Eu(i,e,t,n){let s=e+""+t,o=wu.get(i);s!=o&&(wu.set(i,s),i.style.height=t+"px",i.style.width=e+"px",i.style.marginLeft=n?-e/2+"px":0,i.style.marginTop=n?-t/2+"px":0)}const lh={passive:!0},Cg={...lh,capture:!0};function Bs(i,e,t,n){e.addEventListener(i,t,n?Cg:lh)}function sc(i,e,t,n){e.removeEventListener(i,t,lh)}Go&&nc();function si(i,e,t,n){let s;t=t||0,n=n||e.length-1;let o=n<=2147483647;for(;n-t>1;)s=o?t+n>>1:Bn((t+n)/2),e[s]<i?t=s:n=s;return i-e[t]<=e[n]-i?t:n}function Vf(i){return(t,n,s)=>{let o=-1,r=-1;for(let a=n;a<=s;a++)if(i(t[a])){o=a;break}for(let a=s;a>=n;a--)if(i(t[a])){r=a;break}return[o,r]}}const Gf=i=>i!=null,Wf=i=>i!=null&&i>0,Ba=Vf(Gf),Pg=Vf(Wf);function Lg(i,e,t,n=0,s=!1){let o=s?Pg:Ba,r=s?Wf:Gf;[e,t]=o(i,e,t);let a=i[e],l=i[e];if(e>-1)if(n==1)a=i[e],l=i[t];else if(n==-1)a=i[t],l=i[e];else for(let c=e;c<=t;c++){let h=i[c];r(h)&&(h<a?a=h:h>l&&(l=h))}return[a??Pt,l??-Pt]}function za(i,e,t,n){let s=Ru(i),o=Ru(e);i==e&&(s==-1?(i*=t,e/=t):(i/=t,e*=t));let r=t==10?zi:$f,a=s==1?Bn:jn,l=o==1?jn:Bn,c=a(r(Qt(i))),h=l(r(Qt(e))),u=Po(t,c),d=Po(t,h);return t==10&&(c<0&&(u=Lt(u,-c)),h<0&&(d=Lt(d,-h))),n||t==2?(i=u*s,e=d*o):(i=Yf(i,u),e=Ha(e,d)),[i,e]}function ch(i,e,t,n){let s=za(i,e,t,n);return i==0&&(s[0]=0),e==0&&(s[1]=0),s}const hh=.1,Tu={mode:3,pad:hh},_r={pad:0,soft:null,mode:0},Ng={min:_r,max:_r};function Aa(i,e,t,n){return Va(t)?Au(i,e,t):(_r.pad=t,_r.soft=n?0:null,_r.mode=n?3:0,Au(i,e,Ng))}function bt(i,e){return i??e}function Dg(i,e,t){for(e=bt(e,0),t=bt(t,i.length-1);e<=t;){if(i[e]!=null)return!0;e++}return!1}function Au(i,e,t){let n=t.min,s=t.max,o=bt(n.pad,0),r=bt(s.pad,0),a=bt(n.hard,-Pt),l=bt(s.hard,Pt),c=bt(n.soft,Pt),h=bt(s.soft,-Pt),u=bt(n.mode,0),d=bt(s.mode,0),m=e-i,g=zi(m),_=Sn(Qt(i),Qt(e)),p=zi(_),f=Qt(p-g);(m<1e-24||f>10)&&(m=0,(i==0||e==0)&&(m=1e-24,u==2&&c!=Pt&&(o=0),d==2&&h!=-Pt&&(r=0)));let M=m||_||1e3,S=zi(M),x=Po(10,Bn(S)),F=M*(m==0?i==0?.1:1:o),P=Lt(Yf(i-F,x/10),24),A=i>=c&&(u==1||u==3&&P<=c||u==2&&P>=c)?c:Pt,I=Sn(a,P<A&&i>=A?A:ri(A,P)),E=M*(m==0?e==0?.1:1:r),y=Lt(Ha(e+E,x/10),24),R=e<=h&&(d==1||d==3&&y>=h||d==2&&y<=h)?h:-Pt,V=ri(l,y>R&&e<=R?R:Sn(R,y));return I==V&&I==0&&(V=100),[I,V]}const Ig=new Intl.NumberFormat(Go?Rg.language:"en-US"),uh=i=>Ig.format(i),zn=Math,ga=zn.PI,Qt=zn.abs,Bn=zn.floor,Zt=zn.round,jn=zn.ceil,ri=zn.min,Sn=zn.max,Po=zn.pow,Ru=zn.sign,zi=zn.log10,$f=zn.log2,Ug=(i,e=1)=>zn.sinh(i)*e,fl=(i,e=1)=>zn.asinh(i/e),Pt=1/0;function Cu(i){return(zi((i^i>>31)-(i>>31))|0)+1}function oc(i,e,t){return ri(Sn(i,e),t)}function qf(i){return typeof i=="function"}function at(i){return qf(i)?i:()=>i}const kg=()=>{},Xf=i=>i,jf=(i,e)=>e,Fg=i=>null,Pu=i=>!0,Lu=(i,e)=>i==e,Og=/\.\d*?(?=9{6,}|0{6,})/gm,Hs=i=>{if(Zf(i)||us.has(i))return i;const e=`${i}`,t=e.match(Og);if(t==null)return i;let n=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,o]=e.split("e");return+`${Hs(s)}e${o}`}return Lt(i,n)};function Ps(i,e){return Hs(Lt(Hs(i/e))*e)}function Ha(i,e){return Hs(jn(Hs(i/e))*e)}function Yf(i,e){return Hs(Bn(Hs(i/e))*e)}function Lt(i,e=0){if(Zf(i))return i;let t=10**e,n=i*t*(1+Number.EPSILON);return Zt(n)/t}const us=new Map;function Kf(i){return((""+i).split(".")[1]||"").length}function yr(i,e,t,n){let s=[],o=n.map(Kf);for(let r=e;r<t;r++){let a=Qt(r),l=Lt(Po(i,r),a);for(let c=0;c<n.length;c++){let h=i==10?+`${n[c]}e${r}`:n[c]*l,u=(r>=0?0:a)+(r>=o[c]?0:o[c]),d=i==10?h:Lt(h,u);s.push(d),us.set(d,u)}}return s}const vr={},dh=[],Lo=[null,null],is=Array.isArray,Zf=Number.isInteger,Bg=i=>i===void 0;function Nu(i){return typeof i=="string"}function Va(i){let e=!1;if(i!=null){let t=i.constructor;e=t==null||t==Object}return e}function zg(i){return i!=null&&typeof i=="object"}const Hg=Object.getPrototypeOf(Uint8Array),Jf="__proto__";function No(i,e=Va){let t;if(is(i)){let n=i.find(s=>s!=null);if(is(n)||e(n)){t=Array(i.length);for(let s=0;s<i.length;s++)t[s]=No(i[s],e)}else t=i.slice()}else if(i instanceof Hg)t=i.slice();else if(e(i)){t={};for(let n in i)n!=Jf&&(t[n]=No(i[n],e))}else t=i;return t}function jt(i){let e=arguments;for(let t=1;t<e.length;t++){let n=e[t];for(let s in n)s!=Jf&&(Va(i[s])?jt(i[s],No(n[s])):i[s]=No(n[s]))}return i}const Vg=0,Gg=1,Wg=2;function $g(i,e,t){for(let n=0,s,o=-1;n<e.length;n++){let r=e[n];if(r>o){for(s=r-1;s>=0&&i[s]==null;)i[s--]=null;for(s=r+1;s<t&&i[s]==null;)i[o=s++]=null}}}function qg(i,e){if(Yg(i)){let r=i[0].slice();for(let a=1;a<i.length;a++)r.push(...i[a].slice(1));return Kg(r[0])||(r=jg(r)),r}let t=new Set;for(let r=0;r<i.length;r++){let l=i[r][0],c=l.length;for(let h=0;h<c;h++)t.add(l[h])}let n=[Array.from(t).sort((r,a)=>r-a)],s=n[0].length,o=new Map;for(let r=0;r<s;r++)o.set(n[0][r],r);for(let r=0;r<i.length;r++){let a=i[r],l=a[0];for(let c=1;c<a.length;c++){let h=a[c],u=Array(s).fill(void 0),d=e?e[r][c]:Gg,m=[];for(let g=0;g<h.length;g++){let _=h[g],p=o.get(l[g]);_===null?d!=Vg&&(u[p]=_,d==Wg&&m.push(p)):u[p]=_}$g(u,m,s),n.push(u)}}return n}const Xg=typeof queueMicrotask>"u"?i=>Promise.resolve().then(i):queueMicrotask;function jg(i){let e=i[0],t=e.length,n=Array(t);for(let o=0;o<n.length;o++)n[o]=o;n.sort((o,r)=>e[o]-e[r]);let s=[];for(let o=0;o<i.length;o++){let r=i[o],a=Array(t);for(let l=0;l<t;l++)a[l]=r[n[l]];s.push(a)}return s}function Yg(i){let e=i[0][0],t=e.length;for(let n=1;n<i.length;n++){let s=i[n][0];if(s.length!=t)return!1;if(s!=e){for(let o=0;o<t;o++)if(s[o]!=e[o])return!1}}return!0}function Kg(i,e=100){const t=i.length;if(t<=1)return!0;let n=0,s=t-1;for(;n<=s&&i[n]==null;)n++;for(;s>=n&&i[s]==null;)s--;if(s<=n)return!0;const o=Sn(1,Bn((s-n+1)/e));for(let r=i[n],a=n+o;a<=s;a+=o){const l=i[a];if(l!=null){if(l<=r)return!1;r=l}}return!0}const Qf=["January","February","March","April","May","June","July","August","September","October","November","December"],ep=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function tp(i){return i.slice(0,3)}const Zg=ep.map(tp),Jg=Qf.map(tp),Qg={MMMM:Qf,MMM:Jg,WWWW:ep,WWW:Zg};function nr(i){return(i<10?"0":"")+i}function e0(i){return(i<10?"00":i<100?"0":"")+i}const t0={YYYY:i=>i.getFullYear(),YY:i=>(i.getFullYear()+"").slice(2),MMMM:(i,e)=>e.MMMM[i.getMonth()],MMM:(i,e)=>e.MMM[i.getMonth()],MM:i=>nr(i.getMonth()+1),M:i=>i.getMonth()+1,DD:i=>nr(i.getDate()),D:i=>i.getDate(),WWWW:(i,e)=>e.WWWW[i.getDay()],WWW:(i,e)=>e.WWW[i.getDay()],HH:i=>nr(i.getHours()),H:i=>i.getHours(),h:i=>{let e=i.getHours();return e==0?12:e>12?e-12:e},AA:i=>i.getHours()>=12?"PM":"AM",aa:i=>i.getHours()>=12?"pm":"am",a:i=>i.getHours()>=12?"p":"a",mm:i=>nr(i.getMinutes()),m:i=>i.getMinutes(),ss:i=>nr(i.getSeconds()),s:i=>i.getSeconds(),fff:i=>e0(i.getMilliseconds())};function fh(i,e){e=e||Qg;let t=[],n=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=n.exec(i);)t.push(s[0][0]=="{"?t0[s[1]]:s[0]);return o=>{let r="";for(let a=0;a<t.length;a++)r+=typeof t[a]=="string"?t[a]:t[a](o,e);return r}}const n0=new Intl.DateTimeFormat().resolvedOptions().timeZone;function i0(i,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+i+i.getTimezoneOffset()*6e4):e==n0?t=i:(t=new Date(i.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(i.getMilliseconds())),t}const np=i=>i%1==0,Ra=[1,2,2.5,5],s0=yr(10,-32,0,Ra),ip=yr(10,0,32,Ra),o0=ip.filter(np),Ls=s0.concat(ip),ph=`
`,sp="{YYYY}",Du=ph+sp,op="{M}/{D}",fr=ph+op,Hr=fr+"/{YY}",rp="{aa}",r0="{h}:{mm}",So=r0+rp,Iu=ph+So,Uu=":{ss}",Et=null;function ap(i){let e=i*1e3,t=e*60,n=t*60,s=n*24,o=s*30,r=s*365,l=(i==1?yr(10,0,3,Ra).filter(np):yr(10,-3,0,Ra)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,n,n*2,n*3,n*4,n*6,n*8,n*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,o,o*2,o*3,o*4,o*6,r,r*2,r*5,r*10,r*25,r*50,r*100]);const c=[[r,sp,Et,Et,Et,Et,Et,Et,1],[s*28,"{MMM}",Du,Et,Et,Et,Et,Et,1],[s,op,Du,Et,Et,Et,Et,Et,1],[n,"{h}"+rp,Hr,Et,fr,Et,Et,Et,1],[t,So,Hr,Et,fr,Et,Et,Et,1],[e,Uu,Hr+" "+So,Et,fr+" "+So,Et,Iu,Et,1],[i,Uu+".{fff}",Hr+" "+So,Et,fr+" "+So,Et,Iu,Et,1]];function h(u){return(d,m,g,_,p,f)=>{let M=[],S=p>=r,x=p>=o&&p<r,F=u(g),P=Lt(F*i,3),A=pl(F.getFullYear(),S?0:F.getMonth(),x||S?1:F.getDate()),I=Lt(A*i,3);if(x||S){let E=x?p/o:0,y=S?p/r:0,R=P==I?P:Lt(pl(A.getFullYear()+y,A.getMonth()+E,1)*i,3),V=new Date(Zt(R/i)),O=V.getFullYear(),$=V.getMonth();for(let q=0;R<=_;q++){let X=pl(O+y*q,$+E*q,1),Y=X-u(Lt(X*i,3));R=Lt((+X+Y)*i,3),R<=_&&M.push(R)}}else{let E=p>=s?s:p,y=Bn(g)-Bn(P),R=I+y+Ha(P-I,E);M.push(R);let V=u(R),O=V.getHours()+V.getMinutes()/t+V.getSeconds()/n,$=p/n,q=d.axes[m]._space,X=f/q;for(;R=Lt(R+p,i==1?0:3),!(R>_);)if($>1){let Y=Bn(Lt(O+$,6))%24,he=u(R).getHours()-Y;he>1&&(he=-1),R-=he*n,O=(O+$)%24;let _e=M[M.length-1];Lt((R-_e)/p,3)*X>=.7&&M.push(R)}else M.push(R)}return M}}return[l,c,h]}const[a0,l0,c0]=ap(1),[h0,u0,d0]=ap(.001);yr(2,-53,53,[1]);function ku(i,e){return i.map(t=>t.map((n,s)=>s==0||s==8||n==null?n:e(s==1||t[8]==0?n:t[1]+n)))}function Fu(i,e){return(t,n,s,o,r)=>{let a=e.find(g=>r>=g[0])||e[e.length-1],l,c,h,u,d,m;return n.map(g=>{let _=i(g),p=_.getFullYear(),f=_.getMonth(),M=_.getDate(),S=_.getHours(),x=_.getMinutes(),F=_.getSeconds(),P=p!=l&&a[2]||f!=c&&a[3]||M!=h&&a[4]||S!=u&&a[5]||x!=d&&a[6]||F!=m&&a[7]||a[1];return l=p,c=f,h=M,u=S,d=x,m=F,P(_)})}}function f0(i,e){let t=fh(e);return(n,s,o,r,a)=>s.map(l=>t(i(l)))}function pl(i,e,t){return new Date(i,e,t)}function Ou(i,e){return e(i)}const p0="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function Bu(i,e){return(t,n,s,o)=>o==null?ah:e(i(n))}function m0(i,e){let t=i.series[e];return t.width?t.stroke(i,e):t.points.width?t.points.stroke(i,e):null}function g0(i,e){return i.series[e].fill(i,e)}const _0={show:!0,live:!0,isolate:!1,mount:kg,markers:{show:!0,width:2,stroke:m0,fill:g0,dash:"solid"},idx:null,idxs:null,values:[]};function v0(i,e){let t=i.cursor.points,n=qn(),s=t.size(i,e);kt(n,ur,s),kt(n,dr,s);let o=s/-2;kt(n,"marginLeft",o),kt(n,"marginTop",o);let r=t.width(i,e,s);return r&&kt(n,"borderWidth",r),n}function x0(i,e){let t=i.series[e].points;return t._fill||t._stroke}function b0(i,e){let t=i.series[e].points;return t._stroke||t._fill}function y0(i,e){return i.series[e].points.size}const ml=[0,0];function M0(i,e,t){return ml[0]=e,ml[1]=t,ml}function Vr(i,e,t,n=!0){return s=>{s.button==0&&(!n||s.target==e)&&t(s)}}function gl(i,e,t,n=!0){return s=>{(!n||s.target==e)&&t(s)}}const S0={show:!0,x:!0,y:!0,lock:!1,move:M0,points:{one:!1,show:v0,size:y0,width:0,stroke:b0,fill:x0},bind:{mousedown:Vr,mouseup:Vr,click:Vr,dblclick:Vr,mousemove:gl,mouseleave:gl,mouseenter:gl},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(i,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(i,e,t,n,s)=>n-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},lp={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},mh=jt({},lp,{filter:jf}),cp=jt({},mh,{size:10}),hp=jt({},lp,{show:!1}),gh='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',up="bold "+gh,dp=1.5,zu={show:!0,scale:"x",stroke:rh,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:up,side:2,grid:mh,ticks:cp,border:hp,font:gh,lineGap:dp,rotate:0},w0="Value",E0="Time",Hu={show:!0,scale:"x",auto:!1,sorted:1,min:Pt,max:-Pt,idxs:[]};function T0(i,e,t,n,s){return e.map(o=>o==null?"":uh(o))}function A0(i,e,t,n,s,o,r){let a=[],l=us.get(s)||0;t=r?t:Lt(Ha(t,s),l);for(let c=t;c<=n;c=Lt(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function rc(i,e,t,n,s,o,r){const a=[],l=i.scales[i.axes[e].scale].log,c=l==10?zi:$f,h=Bn(c(t));s=Po(l,h),l==10&&(s=Ls[si(s,Ls)]);let u=t,d=s*l;l==10&&(d=Ls[si(d,Ls)]);do a.push(u),u=u+s,l==10&&!us.has(u)&&(u=Lt(u,us.get(s))),u>=d&&(s=u,d=s*l,l==10&&(d=Ls[si(d,Ls)]));while(u<=n);return a}function R0(i,e,t,n,s,o,r){let l=i.scales[i.axes[e].scale].asinh,c=n>l?rc(i,e,Sn(l,t),n,s):[l],h=n>=0&&t<=0?[0]:[];return(t<-l?rc(i,e,Sn(l,-n),-t,s):[l]).reverse().map(d=>-d).concat(h,c)}const fp=/./,C0=/[12357]/,P0=/[125]/,Vu=/1/,ac=(i,e,t,n)=>i.map((s,o)=>e==4&&s==0||o%n==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function L0(i,e,t,n,s){let o=i.axes[t],r=o.scale,a=i.scales[r],l=i.valToPos,c=o._space,h=l(10,r),u=l(9,r)-h>=c?fp:l(7,r)-h>=c?C0:l(5,r)-h>=c?P0:Vu;if(u==Vu){let d=Qt(l(1,r)-h);if(d<c)return ac(e.slice().reverse(),a.distr,u,jn(c/d)).reverse()}return ac(e,a.distr,u,1)}function N0(i,e,t,n,s){let o=i.axes[t],r=o.scale,a=o._space,l=i.valToPos,c=Qt(l(1,r)-l(2,r));return c<a?ac(e.slice().reverse(),3,fp,jn(a/c)).reverse():e}function D0(i,e,t,n){return n==null?ah:e==null?"":uh(e)}const Gu={show:!0,scale:"y",stroke:rh,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:up,side:3,grid:mh,ticks:cp,border:hp,font:gh,lineGap:dp,rotate:0};function I0(i,e){let t=3+(i||1)*2;return Lt(t*e,3)}function U0(i,e){let{scale:t,idxs:n}=i.series[0],s=i._data[0],o=i.valToPos(s[n[0]],t,!0),r=i.valToPos(s[n[1]],t,!0),a=Qt(r-o),l=i.series[e],c=a/(l.points.space*St);return n[1]-n[0]<=c}const Wu={scale:null,auto:!0,sorted:0,min:Pt,max:-Pt},pp=(i,e,t,n,s)=>s,$u={show:!0,auto:!0,sorted:0,gaps:pp,alpha:1,facets:[jt({},Wu,{scale:"x"}),jt({},Wu,{scale:"y"})]},qu={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:pp,alpha:1,points:{show:U0,filter:null},values:null,min:Pt,max:-Pt,idxs:[],path:null,clip:null};function k0(i,e,t,n,s){return t/10}const mp={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},F0=jt({},mp,{time:!1,ori:1}),Xu={};function gp(i,e){let t=Xu[i];return t||(t={key:i,plots:[],sub(n){t.plots.push(n)},unsub(n){t.plots=t.plots.filter(s=>s!=n)},pub(n,s,o,r,a,l,c){for(let h=0;h<t.plots.length;h++)t.plots[h]!=s&&t.plots[h].pub(n,s,o,r,a,l,c)}},i!=null&&(Xu[i]=t)),t}const Do=1,lc=2;function qs(i,e,t){const n=i.mode,s=i.series[e],o=n==2?i._data[e]:i._data,r=i.scales,a=i.bbox;let l=o[0],c=n==2?o[1]:o[e],h=n==2?r[s.facets[0].scale]:r[i.series[0].scale],u=n==2?r[s.facets[1].scale]:r[s.scale],d=a.left,m=a.top,g=a.width,_=a.height,p=i.valToPosH,f=i.valToPosV;return h.ori==0?t(s,l,c,h,u,p,f,d,m,g,_,Wa,Wo,qa,vp,bp):t(s,l,c,h,u,f,p,m,d,_,g,$a,$o,xh,xp,yp)}function _h(i,e){let t=0,n=0,s=bt(i.bands,dh);for(let o=0;o<s.length;o++){let r=s[o];r.series[0]==e?t=r.dir:r.series[1]==e&&(r.dir==1?n|=1:n|=2)}return[t,n==1?-1:n==2?1:n==3?2:0]}function O0(i,e,t,n,s){let o=i.mode,r=i.series[e],a=o==2?r.facets[1].scale:r.scale,l=i.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Hi(i,e,t,n,s,o){return qs(i,e,(r,a,l,c,h,u,d,m,g,_,p)=>{let f=r.pxRound;const M=c.dir*(c.ori==0?1:-1),S=c.ori==0?Wo:$o;let x,F;M==1?(x=t,F=n):(x=n,F=t);let P=f(u(a[x],c,_,m)),A=f(d(l[x],h,p,g)),I=f(u(a[F],c,_,m)),E=f(d(o==1?h.max:h.min,h,p,g)),y=new Path2D(s);return S(y,I,E),S(y,P,E),S(y,P,A),y})}function Ga(i,e,t,n,s,o){let r=null;if(i.length>0){r=new Path2D;const a=e==0?qa:xh;let l=t;for(let u=0;u<i.length;u++){let d=i[u];if(d[1]>d[0]){let m=d[0]-l;m>0&&a(r,l,n,m,n+o),l=d[1]}}let c=t+s-l,h=10;c>0&&a(r,l,n-h/2,c,n+o+h)}return r}function B0(i,e,t){let n=i[i.length-1];n&&n[0]==e?n[1]=t:i.push([e,t])}function vh(i,e,t,n,s,o,r){let a=[],l=i.length;for(let c=s==1?t:n;c>=t&&c<=n;c+=s)if(e[c]===null){let u=c,d=c;if(s==1)for(;++c<=n&&e[c]===null;)d=c;else for(;--c>=t&&e[c]===null;)d=c;let m=o(i[u]),g=d==u?m:o(i[d]),_=u-s;m=r<=0&&_>=0&&_<l?o(i[_]):m;let f=d+s;g=r>=0&&f>=0&&f<l?o(i[f]):g,g>=m&&a.push([m,g])}return a}function ju(i){return i==0?Xf:i==1?Zt:e=>Ps(e,i)}function _p(i){let e=i==0?Wa:$a,t=i==0?(s,o,r,a,l,c)=>{s.arcTo(o,r,a,l,c)}:(s,o,r,a,l,c)=>{s.arcTo(r,o,l,a,c)},n=i==0?(s,o,r,a,l)=>{s.rect(o,r,a,l)}:(s,o,r,a,l)=>{s.rect(r,o,l,a)};return(s,o,r,a,l,c=0,h=0)=>{c==0&&h==0?n(s,o,r,a,l):(c=ri(c,a/2,l/2),h=ri(h,a/2,l/2),e(s,o+c,r),t(s,o+a,r,o+a,r+l,c),t(s,o+a,r+l,o,r+l,h),t(s,o,r+l,o,r,h),t(s,o,r,o+a,r,c),s.closePath())}}const Wa=(i,e,t)=>{i.moveTo(e,t)},$a=(i,e,t)=>{i.moveTo(t,e)},Wo=(i,e,t)=>{i.lineTo(e,t)},$o=(i,e,t)=>{i.lineTo(t,e)},qa=_p(0),xh=_p(1),vp=(i,e,t,n,s,o)=>{i.arc(e,t,n,s,o)},xp=(i,e,t,n,s,o)=>{i.arc(t,e,n,s,o)},bp=(i,e,t,n,s,o,r)=>{i.bezierCurveTo(e,t,n,s,o,r)},yp=(i,e,t,n,s,o,r)=>{i.bezierCurveTo(t,e,s,n,r,o)};function Mp(i){return(e,t,n,s,o)=>qs(e,t,(r,a,l,c,h,u,d,m,g,_,p)=>{let{pxRound:f,points:M}=r,S,x;c.ori==0?(S=Wa,x=vp):(S=$a,x=xp);const F=Lt(M.width*St,3);let P=(M.size-M.width)/2*St,A=Lt(P*2,3),I=new Path2D,E=new Path2D,{left:y,top:R,width:V,height:O}=e.bbox;qa(E,y-A,R-A,V+A*2,O+A*2);const $=q=>{if(l[q]!=null){let X=f(u(a[q],c,_,m)),Y=f(d(l[q],h,p,g));S(I,X+P,Y),x(I,X,Y,P,0,ga*2)}};if(o)o.forEach($);else for(let q=n;q<=s;q++)$(q);return{stroke:F>0?I:null,fill:I,clip:E,flags:Do|lc}})}function Sp(i){return(e,t,n,s,o,r)=>{n!=s&&(o!=n&&r!=n&&i(e,t,n),o!=s&&r!=s&&i(e,t,s),i(e,t,r))}}const z0=Sp(Wo),H0=Sp($o);function wp(i){const e=bt(i?.alignGaps,0);return(t,n,s,o)=>qs(t,n,(r,a,l,c,h,u,d,m,g,_,p)=>{[s,o]=Ba(l,s,o);let f=r.pxRound,M=O=>f(u(O,c,_,m)),S=O=>f(d(O,h,p,g)),x,F;c.ori==0?(x=Wo,F=z0):(x=$o,F=H0);const P=c.dir*(c.ori==0?1:-1),A={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Do},I=A.stroke;let E=!1;if(o-s>=_*4){let O=ge=>t.posToVal(ge,c.key,!0),$=null,q=null,X,Y,te,le=M(a[P==1?s:o]),he=M(a[s]),_e=M(a[o]),Me=O(P==1?he+1:_e-1);for(let ge=P==1?s:o;ge>=s&&ge<=o;ge+=P){let oe=a[ge],ve=(P==1?oe<Me:oe>Me)?le:M(oe),ce=l[ge];ve==le?ce!=null?(Y=ce,$==null?(x(I,ve,S(Y)),X=$=q=Y):Y<$?$=Y:Y>q&&(q=Y)):ce===null&&(E=!0):($!=null&&F(I,le,S($),S(q),S(X),S(Y)),ce!=null?(Y=ce,x(I,ve,S(Y)),$=q=X=Y):($=q=null,ce===null&&(E=!0)),le=ve,Me=O(le+P))}$!=null&&$!=q&&te!=le&&F(I,le,S($),S(q),S(X),S(Y))}else for(let O=P==1?s:o;O>=s&&O<=o;O+=P){let $=l[O];$===null?E=!0:$!=null&&x(I,M(a[O]),S($))}let[R,V]=_h(t,n);if(r.fill!=null||R!=0){let O=A.fill=new Path2D(I),$=r.fillTo(t,n,r.min,r.max,R),q=S($),X=M(a[s]),Y=M(a[o]);P==-1&&([Y,X]=[X,Y]),x(O,Y,q),x(O,X,q)}if(!r.spanGaps){let O=[];E&&O.push(...vh(a,l,s,o,P,M,e)),A.gaps=O=r.gaps(t,n,s,o,O),A.clip=Ga(O,c.ori,m,g,_,p)}return V!=0&&(A.band=V==2?[Hi(t,n,s,o,I,-1),Hi(t,n,s,o,I,1)]:Hi(t,n,s,o,I,V)),A})}function V0(i){const e=bt(i.align,1),t=bt(i.ascDesc,!1),n=bt(i.alignGaps,0),s=bt(i.extend,!1);return(o,r,a,l)=>qs(o,r,(c,h,u,d,m,g,_,p,f,M,S)=>{[a,l]=Ba(u,a,l);let x=c.pxRound,{left:F,width:P}=o.bbox,A=he=>x(g(he,d,M,p)),I=he=>x(_(he,m,S,f)),E=d.ori==0?Wo:$o;const y={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Do},R=y.stroke,V=d.dir*(d.ori==0?1:-1);let O=I(u[V==1?a:l]),$=A(h[V==1?a:l]),q=$,X=$;s&&e==-1&&(X=F,E(R,X,O)),E(R,$,O);for(let he=V==1?a:l;he>=a&&he<=l;he+=V){let _e=u[he];if(_e==null)continue;let Me=A(h[he]),ge=I(_e);e==1?E(R,Me,O):E(R,q,ge),E(R,Me,ge),O=ge,q=Me}let Y=q;s&&e==1&&(Y=F+P,E(R,Y,O));let[te,le]=_h(o,r);if(c.fill!=null||te!=0){let he=y.fill=new Path2D(R),_e=c.fillTo(o,r,c.min,c.max,te),Me=I(_e);E(he,Y,Me),E(he,X,Me)}if(!c.spanGaps){let he=[];he.push(...vh(h,u,a,l,V,A,n));let _e=c.width*St/2,Me=t||e==1?_e:-_e,ge=t||e==-1?-_e:_e;he.forEach(oe=>{oe[0]+=Me,oe[1]+=ge}),y.gaps=he=c.gaps(o,r,a,l,he),y.clip=Ga(he,d.ori,p,f,M,S)}return le!=0&&(y.band=le==2?[Hi(o,r,a,l,R,-1),Hi(o,r,a,l,R,1)]:Hi(o,r,a,l,R,le)),y})}function Yu(i,e,t,n,s,o,r=Pt){if(i.length>1){let a=null;for(let l=0,c=1/0;l<i.length;l++)if(e[l]!==void 0){if(a!=null){let h=Qt(i[l]-i[a]);h<c&&(c=h,r=Qt(t(i[l],n,s,o)-t(i[a],n,s,o)))}a=l}}return r}function G0(i){i=i||vr;const e=bt(i.size,[.6,Pt,1]),t=i.align||0,n=i.gap||0;let s=i.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;const o=at(s),r=1-e[0],a=bt(e[1],Pt),l=bt(e[2],1),c=bt(i.disp,vr),h=bt(i.each,m=>{}),{fill:u,stroke:d}=c;return(m,g,_,p)=>qs(m,g,(f,M,S,x,F,P,A,I,E,y,R)=>{let V=f.pxRound,O=t,$=n*St,q=a*St,X=l*St,Y,te;x.ori==0?[Y,te]=o(m,g):[te,Y]=o(m,g);const le=x.dir*(x.ori==0?1:-1);let he=x.ori==0?qa:xh,_e=x.ori==0?h:(j,ie,Se,xe,Ae,Ke,pe)=>{h(j,ie,Se,Ae,xe,pe,Ke)},Me=bt(m.bands,dh).find(j=>j.series[0]==g),ge=Me!=null?Me.dir:0,oe=f.fillTo(m,g,f.min,f.max,ge),ue=V(A(oe,F,R,E)),ve,ce,He,Ge=y,ke=V(f.width*St),ct=!1,Ze=null,ht=null,G=null,Yt=null;u!=null&&(ke==0||d!=null)&&(ct=!0,Ze=u.values(m,g,_,p),ht=new Map,new Set(Ze).forEach(j=>{j!=null&&ht.set(j,new Path2D)}),ke>0&&(G=d.values(m,g,_,p),Yt=new Map,new Set(G).forEach(j=>{j!=null&&Yt.set(j,new Path2D)})));let{x0:et,size:nt}=c;if(et!=null&&nt!=null){O=1,M=et.values(m,g,_,p),et.unit==2&&(M=M.map(Se=>m.posToVal(I+Se*y,x.key,!0)));let j=nt.values(m,g,_,p);nt.unit==2?ce=j[0]*y:ce=P(j[0],x,y,I)-P(0,x,y,I),Ge=Yu(M,S,P,x,y,I,Ge),He=Ge-ce+$}else Ge=Yu(M,S,P,x,y,I,Ge),He=Ge*r+$,ce=Ge-He;He<1&&(He=0),ke>=ce/2&&(ke=0),He<5&&(V=Xf);let We=He>0,ft=Ge-He-(We?ke:0);ce=V(oc(ft,X,q)),ve=(O==0?ce/2:O==le?0:ce)-O*le*((O==0?$/2:0)+(We?ke/2:0));const Ne={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},L=ct?null:new Path2D;let w=null;if(Me!=null)w=m.data[Me.series[1]];else{let{y0:j,y1:ie}=c;j!=null&&ie!=null&&(S=ie.values(m,g,_,p),w=j.values(m,g,_,p))}let Q=Y*ce,ne=te*ce;for(let j=le==1?_:p;j>=_&&j<=p;j+=le){let ie=S[j];if(ie==null)continue;if(w!=null){let Be=w[j]??0;if(ie-Be==0)continue;ue=A(Be,F,R,E)}let Se=x.distr!=2||c!=null?M[j]:j,xe=P(Se,x,y,I),Ae=A(bt(ie,oe),F,R,E),Ke=V(xe-ve),pe=V(Sn(Ae,ue)),be=V(ri(Ae,ue)),Fe=pe-be;if(ie!=null){let Be=ie<0?ne:Q,Ee=ie<0?Q:ne;ct?(ke>0&&G[j]!=null&&he(Yt.get(G[j]),Ke,be+Bn(ke/2),ce,Sn(0,Fe-ke),Be,Ee),Ze[j]!=null&&he(ht.get(Ze[j]),Ke,be+Bn(ke/2),ce,Sn(0,Fe-ke),Be,Ee)):he(L,Ke,be+Bn(ke/2),ce,Sn(0,Fe-ke),Be,Ee),_e(m,g,j,Ke-ke/2,be,ce+ke,Fe)}}return ke>0?Ne.stroke=ct?Yt:L:ct||(Ne._fill=f.width==0?f._fill:f._stroke??f._fill,Ne.width=0),Ne.fill=ct?ht:L,Ne})}function W0(i,e){const t=bt(e?.alignGaps,0);return(n,s,o,r)=>qs(n,s,(a,l,c,h,u,d,m,g,_,p,f)=>{[o,r]=Ba(c,o,r);let M=a.pxRound,S=Y=>M(d(Y,h,p,g)),x=Y=>M(m(Y,u,f,_)),F,P,A;h.ori==0?(F=Wa,A=Wo,P=bp):(F=$a,A=$o,P=yp);const I=h.dir*(h.ori==0?1:-1);let E=S(l[I==1?o:r]),y=E,R=[],V=[];for(let Y=I==1?o:r;Y>=o&&Y<=r;Y+=I)if(c[Y]!=null){let le=l[Y],he=S(le);R.push(y=he),V.push(x(c[Y]))}const O={stroke:i(R,V,F,A,P,M),fill:null,clip:null,band:null,gaps:null,flags:Do},$=O.stroke;let[q,X]=_h(n,s);if(a.fill!=null||q!=0){let Y=O.fill=new Path2D($),te=a.fillTo(n,s,a.min,a.max,q),le=x(te);A(Y,y,le),A(Y,E,le)}if(!a.spanGaps){let Y=[];Y.push(...vh(l,c,o,r,I,S,t)),O.gaps=Y=a.gaps(n,s,o,r,Y),O.clip=Ga(Y,h.ori,g,_,p,f)}return X!=0&&(O.band=X==2?[Hi(n,s,o,r,$,-1),Hi(n,s,o,r,$,1)]:Hi(n,s,o,r,$,X)),O})}function $0(i){return W0(q0,i)}function q0(i,e,t,n,s,o){const r=i.length;if(r<2)return null;const a=new Path2D;if(t(a,i[0],e[0]),r==2)n(a,i[1],e[1]);else{let l=Array(r),c=Array(r-1),h=Array(r-1),u=Array(r-1);for(let d=0;d<r-1;d++)h[d]=e[d+1]-e[d],u[d]=i[d+1]-i[d],c[d]=h[d]/u[d];l[0]=c[0];for(let d=1;d<r-1;d++)c[d]===0||c[d-1]===0||c[d-1]>0!=c[d]>0?l[d]=0:(l[d]=3*(u[d-1]+u[d])/((2*u[d]+u[d-1])/c[d-1]+(u[d]+2*u[d-1])/c[d]),isFinite(l[d])||(l[d]=0));l[r-1]=c[r-2];for(let d=0;d<r-1;d++)s(a,i[d]+u[d]/3,e[d]+l[d]*u[d]/3,i[d+1]-u[d]/3,e[d+1]-l[d+1]*u[d]/3,i[d+1],e[d+1])}return a}const cc=new Set;function Ku(){for(let i of cc)i.syncRect(!0)}Go&&(Bs(Tg,To,Ku),Bs(Ag,To,Ku,!0),Bs(Ta,To,()=>{_n.pxRatio=St}));const X0=wp(),j0=Mp();function Zu(i,e,t,n){return(n?[i[0],i[1]].concat(i.slice(2)):[i[0]].concat(i.slice(1))).map((o,r)=>hc(o,r,e,t))}function Y0(i,e){return i.map((t,n)=>n==0?{}:jt({},e,t))}function hc(i,e,t,n){return jt({},e==0?t:n,i)}function Ep(i,e,t){return e==null?Lo:[e,t]}const K0=Ep;function Z0(i,e,t){return e==null?Lo:Aa(e,t,hh,!0)}function Tp(i,e,t,n){return e==null?Lo:za(e,t,i.scales[n].log,!1)}const J0=Tp;function Ap(i,e,t,n){return e==null?Lo:ch(e,t,i.scales[n].log,!1)}const Q0=Ap;function e_(i,e,t,n,s){let o=Sn(Cu(i),Cu(e)),r=e-i,a=si(s/n*r,t);do{let l=t[a],c=n*l/r;if(c>=s&&o+(l<5?us.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function Ju(i){let e,t;return i=i.replace(/(\d+)px/,(n,s)=>(e=Zt((t=+s)*St))+"px"),[i,e,t]}function t_(i){i.show&&[i.font,i.labelFont].forEach(e=>{let t=Lt(e[2]*St,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function _n(i,e,t){const n={mode:bt(i.mode,1)},s=n.mode;function o(v,b,C,D){let B=b.valToPct(v);return D+C*(b.dir==-1?1-B:B)}function r(v,b,C,D){let B=b.valToPct(v);return D+C*(b.dir==-1?B:1-B)}function a(v,b,C,D){return b.ori==0?o(v,b,C,D):r(v,b,C,D)}n.valToPosH=o,n.valToPosV=r;let l=!1;n.status=0;const c=n.root=qn(lg);if(i.id!=null&&(c.id=i.id),Fn(c,i.class),i.title){let v=qn(ug,c);v.textContent=i.title}const h=ii("canvas"),u=n.ctx=h.getContext("2d"),d=qn(dg,c);Bs("click",d,v=>{v.target===g&&(Dt!=eo||Bt!=to)&&hn.click(n,v)},!0);const m=n.under=qn(fg,d);d.appendChild(h);const g=n.over=qn(pg,d);i=No(i);const _=+bt(i.pxAlign,1),p=ju(_);(i.plugins||[]).forEach(v=>{v.opts&&(i=v.opts(n,i)||i)});const f=i.ms||.001,M=n.series=s==1?Zu(i.series||[],Hu,qu,!1):Y0(i.series||[null],$u),S=n.axes=Zu(i.axes||[],zu,Gu,!0),x=n.scales={},F=n.bands=i.bands||[];F.forEach(v=>{v.fill=at(v.fill||null),v.dir=bt(v.dir,-1)});const P=s==2?M[1].facets[0].scale:M[0].scale,A={axes:Xm,series:Hn},I=(i.drawOrder||["axes","series"]).map(v=>A[v]);function E(v){const b=v.distr==3?C=>zi(C>0?C:v.clamp(n,C,v.min,v.max,v.key)):v.distr==4?C=>fl(C,v.asinh):v.distr==100?C=>v.fwd(C):C=>C;return C=>{let D=b(C),{_min:B,_max:J}=v,re=J-B;return(D-B)/re}}function y(v){let b=x[v];if(b==null){let C=(i.scales||vr)[v]||vr;if(C.from!=null){y(C.from);let D=jt({},x[C.from],C,{key:v});D.valToPct=E(D),x[v]=D}else{b=x[v]=jt({},v==P?mp:F0,C),b.key=v;let D=b.time,B=b.range,J=is(B);if((v!=P||s==2&&!D)&&(J&&(B[0]==null||B[1]==null)&&(B={min:B[0]==null?Tu:{mode:1,hard:B[0],soft:B[0]},max:B[1]==null?Tu:{mode:1,hard:B[1],soft:B[1]}},J=!1),!J&&Va(B))){let re=B;B=(de,me,Pe)=>me==null?Lo:Aa(me,Pe,re)}b.range=at(B||(D?K0:v==P?b.distr==3?J0:b.distr==4?Q0:Ep:b.distr==3?Tp:b.distr==4?Ap:Z0)),b.auto=at(J?!1:b.auto),b.clamp=at(b.clamp||k0),b._min=b._max=null,b.valToPct=E(b)}}}y("x"),y("y"),s==1&&M.forEach(v=>{y(v.scale)}),S.forEach(v=>{y(v.scale)});for(let v in i.scales)y(v);const R=x[P],V=R.distr;let O,$;R.ori==0?(Fn(c,cg),O=o,$=r):(Fn(c,hg),O=r,$=o);const q={};for(let v in x){let b=x[v];(b.min!=null||b.max!=null)&&(q[v]={min:b.min,max:b.max},b.min=b.max=null)}const X=i.tzDate||(v=>new Date(Zt(v/f))),Y=i.fmtDate||fh,te=f==1?c0(X):d0(X),le=Fu(X,ku(f==1?l0:u0,Y)),he=Bu(X,Ou(p0,Y)),_e=[],Me=n.legend=jt({},_0,i.legend),ge=n.cursor=jt({},S0,{drag:{y:s==2}},i.cursor),oe=Me.show,ue=ge.show,ve=Me.markers;Me.idxs=_e,ve.width=at(ve.width),ve.dash=at(ve.dash),ve.stroke=at(ve.stroke),ve.fill=at(ve.fill);let ce,He,Ge,ke=[],ct=[],Ze,ht=!1,G={};if(Me.live){const v=M[1]?M[1].values:null;ht=v!=null,Ze=ht?v(n,1,0):{_:0};for(let b in Ze)G[b]=ah}if(oe)if(ce=ii("table",bg,c),Ge=ii("tbody",null,ce),Me.mount(n,ce),ht){He=ii("thead",null,ce,Ge);let v=ii("tr",null,He);ii("th",null,v);for(var Yt in Ze)ii("th",fu,v).textContent=Yt}else Fn(ce,Mg),Me.live&&Fn(ce,yg);const et={show:!0},nt={show:!1};function We(v,b){if(b==0&&(ht||!Me.live||s==2))return Lo;let C=[],D=ii("tr",Sg,Ge,Ge.childNodes[b]);Fn(D,v.class),v.show||Fn(D,Ds);let B=ii("th",null,D);if(ve.show){let de=qn(wg,B);if(b>0){let me=ve.width(n,b);me&&(de.style.border=me+"px "+ve.dash(n,b)+" "+ve.stroke(n,b)),de.style.background=ve.fill(n,b)}}let J=qn(fu,B);v.label instanceof HTMLElement?J.appendChild(v.label):J.textContent=v.label,b>0&&(ve.show||(J.style.color=v.width>0?ve.stroke(n,b):ve.fill(n,b)),Ne("click",B,de=>{if(ge._lock)return;Kt(de);let me=M.indexOf(v);if((de.ctrlKey||de.metaKey)!=Me.isolate){let Pe=M.some((Le,De)=>De>0&&De!=me&&Le.show);M.forEach((Le,De)=>{De>0&&fi(De,Pe?De==me?et:nt:et,!0,$t.setSeries)})}else fi(me,{show:!v.show},!0,$t.setSeries)},!1),Ti&&Ne(_u,B,de=>{ge._lock||(Kt(de),fi(M.indexOf(v),io,!0,$t.setSeries))},!1));for(var re in Ze){let de=ii("td",Eg,D);de.textContent="--",C.push(de)}return[D,C]}const ft=new Map;function Ne(v,b,C,D=!0){const B=ft.get(b)||{},J=ge.bind[v](n,b,C,D);J&&(Bs(v,b,B[v]=J),ft.set(b,B))}function L(v,b,C){const D=ft.get(b)||{};for(let B in D)(v==null||B==v)&&(sc(B,b,D[B]),delete D[B]);v==null&&ft.delete(b)}let w=0,Q=0,ne=0,j=0,ie=0,Se=0,xe=ie,Ae=Se,Ke=ne,pe=j,be=0,Fe=0,Be=0,Ee=0;n.bbox={};let st=!1,je=!1,pt=!1,H=!1,ye=!1,se=!1;function ae(v,b,C){(C||v!=n.width||b!=n.height)&&Re(v,b),Ks(!1),pt=!0,je=!0,Zs()}function Re(v,b){n.width=w=ne=v,n.height=Q=j=b,ie=Se=0,nn(),yt();let C=n.bbox;be=C.left=Ps(ie*St,.5),Fe=C.top=Ps(Se*St,.5),Be=C.width=Ps(ne*St,.5),Ee=C.height=Ps(j*St,.5)}const Ce=3;function Je(){let v=!1,b=0;for(;!v;){b++;let C=$m(b),D=qm(b);v=b==Ce||C&&D,v||(Re(n.width,n.height),je=!0)}}function Ft({width:v,height:b}){ae(v,b)}n.setSize=Ft;function nn(){let v=!1,b=!1,C=!1,D=!1;S.forEach((B,J)=>{if(B.show&&B._show){let{side:re,_size:de}=B,me=re%2,Pe=B.label!=null?B.labelSize:0,Le=de+Pe;Le>0&&(me?(ne-=Le,re==3?(ie+=Le,D=!0):C=!0):(j-=Le,re==0?(Se+=Le,v=!0):b=!0))}}),hi[0]=v,hi[1]=C,hi[2]=b,hi[3]=D,ne-=T[1]+T[3],ie+=T[3],j-=T[2]+T[0],Se+=T[0]}function yt(){let v=ie+ne,b=Se+j,C=ie,D=Se;function B(J,re){switch(J){case 1:return v+=re,v-re;case 2:return b+=re,b-re;case 3:return C-=re,C+re;case 0:return D-=re,D+re}}S.forEach((J,re)=>{if(J.show&&J._show){let de=J.side;J._pos=B(de,J._size),J.label!=null&&(J._lpos=B(de,J.labelSize))}})}if(ge.dataIdx==null){let v=ge.hover,b=v.skip=new Set(v.skip??[]);b.add(void 0);let C=v.prox=at(v.prox),D=v.bias??=0;ge.dataIdx=(B,J,re,de)=>{if(J==0)return re;let me=re,Pe=C(B,J,re,de)??Pt,Le=Pe>=0&&Pe<Pt,De=R.ori==0?ne:j,Ye=ge.left,Mt=e[0],xt=e[J];if(b.has(xt[re])){me=null;let ot=null,qe=null,Ve;if(D==0||D==-1)for(Ve=re;ot==null&&Ve-- >0;)b.has(xt[Ve])||(ot=Ve);if(D==0||D==1)for(Ve=re;qe==null&&Ve++<xt.length;)b.has(xt[Ve])||(qe=Ve);if(ot!=null||qe!=null)if(Le){let Ut=ot==null?-1/0:O(Mt[ot],R,De,0),Ht=qe==null?1/0:O(Mt[qe],R,De,0),ln=Ye-Ut,At=Ht-Ye;ln<=At?ln<=Pe&&(me=ot):At<=Pe&&(me=qe)}else me=qe==null?ot:ot==null?qe:re-ot<=qe-re?ot:qe}else Le&&Qt(Ye-O(Mt[re],R,De,0))>Pe&&(me=null);return me}}const Kt=v=>{ge.event=v};ge.idxs=_e,ge._lock=!1;let Nt=ge.points;Nt.show=at(Nt.show),Nt.size=at(Nt.size),Nt.stroke=at(Nt.stroke),Nt.width=at(Nt.width),Nt.fill=at(Nt.fill);const Ln=n.focus=jt({},i.focus||{alpha:.3},ge.focus),Ti=Ln.prox>=0,Tn=Ti&&Nt.one;let fn=[],Ai=[],Ri=[];function _s(v,b){let C=Nt.show(n,b);if(C instanceof HTMLElement)return Fn(C,xg),Fn(C,v.class),_i(C,-10,-10,ne,j),g.insertBefore(C,fn[b]),C}function Ko(v,b){if(s==1||b>0){let C=s==1&&x[v.scale].time,D=v.value;v.value=C?Nu(D)?Bu(X,Ou(D,Y)):D||he:D||D0,v.label=v.label||(C?E0:w0)}if(Tn||b>0){v.width=v.width==null?1:v.width,v.paths=v.paths||X0||Fg,v.fillTo=at(v.fillTo||O0),v.pxAlign=+bt(v.pxAlign,_),v.pxRound=ju(v.pxAlign),v.stroke=at(v.stroke||null),v.fill=at(v.fill||null),v._stroke=v._fill=v._paths=v._focus=null;let C=I0(Sn(1,v.width),1),D=v.points=jt({},{size:C,width:Sn(1,C*.2),stroke:v.stroke,space:C*2,paths:j0,_stroke:null,_fill:null},v.points);D.show=at(D.show),D.filter=at(D.filter),D.fill=at(D.fill),D.stroke=at(D.stroke),D.paths=at(D.paths),D.pxAlign=v.pxAlign}if(oe){let C=We(v,b);ke.splice(b,0,C[0]),ct.splice(b,0,C[1]),Me.values.push(null)}if(ue){_e.splice(b,0,null);let C=null;Tn?b==0&&(C=_s(v,b)):b>0&&(C=_s(v,b)),fn.splice(b,0,C),Ai.splice(b,0,0),Ri.splice(b,0,0)}an("addSeries",b)}function js(v,b){b=b??M.length,v=s==1?hc(v,b,Hu,qu):hc(v,b,{},$u),M.splice(b,0,v),Ko(M[b],b)}n.addSeries=js;function Dr(v){if(M.splice(v,1),oe){Me.values.splice(v,1),ct.splice(v,1);let b=ke.splice(v,1)[0];L(null,b.firstChild),b.remove()}ue&&(_e.splice(v,1),fn.splice(v,1)[0].remove(),Ai.splice(v,1),Ri.splice(v,1)),an("delSeries",v)}n.delSeries=Dr;const hi=[!1,!1,!1,!1];function Ja(v,b){if(v._show=v.show,v.show){let C=v.side%2,D=x[v.scale];D==null&&(v.scale=C?M[1].scale:P,D=x[v.scale]);let B=D.time;v.size=at(v.size),v.space=at(v.space),v.rotate=at(v.rotate),is(v.incrs)&&v.incrs.forEach(re=>{!us.has(re)&&us.set(re,Kf(re))}),v.incrs=at(v.incrs||(D.distr==2?o0:B?f==1?a0:h0:Ls)),v.splits=at(v.splits||(B&&D.distr==1?te:D.distr==3?rc:D.distr==4?R0:A0)),v.stroke=at(v.stroke),v.grid.stroke=at(v.grid.stroke),v.ticks.stroke=at(v.ticks.stroke),v.border.stroke=at(v.border.stroke);let J=v.values;v.values=is(J)&&!is(J[0])?at(J):B?is(J)?Fu(X,ku(J,Y)):Nu(J)?f0(X,J):J||le:J||T0,v.filter=at(v.filter||(D.distr>=3&&D.log==10?L0:D.distr==3&&D.log==2?N0:jf)),v.font=Ju(v.font),v.labelFont=Ju(v.labelFont),v._size=v.size(n,null,b,0),v._space=v._rotate=v._incrs=v._found=v._splits=v._values=null,v._size>0&&(hi[b]=!0,v._el=qn(mg,d))}}function vs(v,b,C,D){let[B,J,re,de]=C,me=b%2,Pe=0;return me==0&&(de||J)&&(Pe=b==0&&!B||b==2&&!re?Zt(zu.size/3):0),me==1&&(B||re)&&(Pe=b==1&&!J||b==3&&!de?Zt(Gu.size/2):0),Pe}const Ir=n.padding=(i.padding||[vs,vs,vs,vs]).map(v=>at(bt(v,vs))),T=n._padding=Ir.map((v,b)=>v(n,b,hi,0));let z,K=null,Z=null;const W=s==1?M[0].idxs:null;let fe=null,we=!1;function Oe(v,b){if(e=v??[],n.data=n._data=e,s==2){z=0;for(let C=1;C<M.length;C++)z+=e[C][0].length}else{e.length==0&&(n.data=n._data=e=[[]]),fe=e[0],z=fe.length;let C=e;if(V==2){C=e.slice();let D=C[0]=Array(z);for(let B=0;B<z;B++)D[B]=B}n._data=e=C}if(Ks(!0),an("setData"),V==2&&(pt=!0),b!==!1){let C=R;C.auto(n,we)?Ie():ji(P,C.min,C.max),H=H||ge.left>=0,se=!0,Zs()}}n.setData=Oe;function Ie(){we=!0;let v,b;s==1&&(z>0?(K=W[0]=0,Z=W[1]=z-1,v=e[0][K],b=e[0][Z],V==2?(v=K,b=Z):v==b&&(V==3?[v,b]=za(v,v,R.log,!1):V==4?[v,b]=ch(v,v,R.log,!1):R.time?b=v+Zt(86400/f):[v,b]=Aa(v,b,hh,!0))):(K=W[0]=v=null,Z=W[1]=b=null)),ji(P,v,b)}let $e,Xe,Ue,rt,wt,Tt,sn,ut,ze,Ot;function mt(v,b,C,D,B,J){v??=mu,C??=dh,D??="butt",B??=mu,J??="round",v!=$e&&(u.strokeStyle=$e=v),B!=Xe&&(u.fillStyle=Xe=B),b!=Ue&&(u.lineWidth=Ue=b),J!=wt&&(u.lineJoin=wt=J),D!=Tt&&(u.lineCap=Tt=D),C!=rt&&u.setLineDash(rt=C)}function An(v,b,C,D){b!=Xe&&(u.fillStyle=Xe=b),v!=sn&&(u.font=sn=v),C!=ut&&(u.textAlign=ut=C),D!=ze&&(u.textBaseline=ze=D)}function ui(v,b,C,D,B=0){if(D.length>0&&v.auto(n,we)&&(b==null||b.min==null)){let J=bt(K,0),re=bt(Z,D.length-1),de=C.min==null?Lg(D,J,re,B,v.distr==3):[C.min,C.max];v.min=ri(v.min,C.min=de[0]),v.max=Sn(v.max,C.max=de[1])}}const pn={min:null,max:null};function xs(){for(let D in x){let B=x[D];q[D]==null&&(B.min==null||q[P]!=null&&B.auto(n,we))&&(q[D]=pn)}for(let D in x){let B=x[D];q[D]==null&&B.from!=null&&q[B.from]!=null&&(q[D]=pn)}q[P]!=null&&Ks(!0);let v={};for(let D in q){let B=q[D];if(B!=null){let J=v[D]=No(x[D],zg);if(B.min!=null)jt(J,B);else if(D!=P||s==2)if(z==0&&J.from==null){let re=J.range(n,null,null,D);J.min=re[0],J.max=re[1]}else J.min=Pt,J.max=-Pt}}if(z>0){M.forEach((D,B)=>{if(s==1){let J=D.scale,re=q[J];if(re==null)return;let de=v[J];if(B==0){let me=de.range(n,de.min,de.max,J);de.min=me[0],de.max=me[1],K=si(de.min,e[0]),Z=si(de.max,e[0]),Z-K>1&&(e[0][K]<de.min&&K++,e[0][Z]>de.max&&Z--),D.min=fe[K],D.max=fe[Z]}else D.show&&D.auto&&ui(de,re,D,e[B],D.sorted);D.idxs[0]=K,D.idxs[1]=Z}else if(B>0&&D.show&&D.auto){let[J,re]=D.facets,de=J.scale,me=re.scale,[Pe,Le]=e[B],De=v[de],Ye=v[me];De!=null&&ui(De,q[de],J,Pe,J.sorted),Ye!=null&&ui(Ye,q[me],re,Le,re.sorted),D.min=re.min,D.max=re.max}});for(let D in v){let B=v[D],J=q[D];if(B.from==null&&(J==null||J.min==null)){let re=B.range(n,B.min==Pt?null:B.min,B.max==-Pt?null:B.max,D);B.min=re[0],B.max=re[1]}}}for(let D in v){let B=v[D];if(B.from!=null){let J=v[B.from];if(J.min==null)B.min=B.max=null;else{let re=B.range(n,J.min,J.max,D);B.min=re[0],B.max=re[1]}}}let b={},C=!1;for(let D in v){let B=v[D],J=x[D];if(J.min!=B.min||J.max!=B.max){J.min=B.min,J.max=B.max;let re=J.distr;J._min=re==3?zi(J.min):re==4?fl(J.min,J.asinh):re==100?J.fwd(J.min):J.min,J._max=re==3?zi(J.max):re==4?fl(J.max,J.asinh):re==100?J.fwd(J.max):J.max,b[D]=C=!0}}if(C){M.forEach((D,B)=>{s==2?B>0&&b.y&&(D._paths=null):b[D.scale]&&(D._paths=null)});for(let D in b)pt=!0,an("setScale",D);ue&&ge.left>=0&&(H=se=!0)}for(let D in q)q[D]=null}function Ct(v){let b=oc(K-1,0,z-1),C=oc(Z+1,0,z-1);for(;v[b]==null&&b>0;)b--;for(;v[C]==null&&C<z-1;)C++;return[b,C]}function Hn(){if(z>0){let v=M.some(b=>b._focus)&&Ot!=Ln.alpha;v&&(u.globalAlpha=Ot=Ln.alpha),M.forEach((b,C)=>{if(C>0&&b.show&&(qi(C,!1),qi(C,!0),b._paths==null)){let D=Ot;Ot!=b.alpha&&(u.globalAlpha=Ot=b.alpha);let B=s==2?[0,e[C][0].length-1]:Ct(e[C]);b._paths=b.paths(n,C,B[0],B[1]),Ot!=D&&(u.globalAlpha=Ot=D)}}),M.forEach((b,C)=>{if(C>0&&b.show){let D=Ot;Ot!=b.alpha&&(u.globalAlpha=Ot=b.alpha),b._paths!=null&&vn(C,!1);{let B=b._paths!=null?b._paths.gaps:null,J=b.points.show(n,C,K,Z,B),re=b.points.filter(n,C,J,B);(J||re)&&(b.points._paths=b.points.paths(n,C,K,Z,re),vn(C,!0))}Ot!=D&&(u.globalAlpha=Ot=D),an("drawSeries",C)}}),v&&(u.globalAlpha=Ot=1)}}function qi(v,b){let C=b?M[v].points:M[v];C._stroke=C.stroke(n,v),C._fill=C.fill(n,v)}function vn(v,b){let C=b?M[v].points:M[v],{stroke:D,fill:B,clip:J,flags:re,_stroke:de=C._stroke,_fill:me=C._fill,_width:Pe=C.width}=C._paths;Pe=Lt(Pe*St,3);let Le=null,De=Pe%2/2;b&&me==null&&(me=Pe>0?"#fff":de);let Ye=C.pxAlign==1&&De>0;if(Ye&&u.translate(De,De),!b){let Mt=be-Pe/2,xt=Fe-Pe/2,ot=Be+Pe,qe=Ee+Pe;Le=new Path2D,Le.rect(Mt,xt,ot,qe)}b?Ys(de,Pe,C.dash,C.cap,me,D,B,re,J):di(v,de,Pe,C.dash,C.cap,me,D,B,re,Le,J),Ye&&u.translate(-De,-De)}function di(v,b,C,D,B,J,re,de,me,Pe,Le){let De=!1;me!=0&&F.forEach((Ye,Mt)=>{if(Ye.series[0]==v){let xt=M[Ye.series[1]],ot=e[Ye.series[1]],qe=(xt._paths||vr).band;is(qe)&&(qe=Ye.dir==1?qe[0]:qe[1]);let Ve,Ut=null;xt.show&&qe&&Dg(ot,K,Z)?(Ut=Ye.fill(n,Mt)||J,Ve=xt._paths.clip):qe=null,Ys(b,C,D,B,Ut,re,de,me,Pe,Le,Ve,qe),De=!0}}),De||Ys(b,C,D,B,J,re,de,me,Pe,Le)}const Zn=Do|lc;function Ys(v,b,C,D,B,J,re,de,me,Pe,Le,De){mt(v,b,C,D,B),(me||Pe||De)&&(u.save(),me&&u.clip(me),Pe&&u.clip(Pe)),De?(de&Zn)==Zn?(u.clip(De),Le&&u.clip(Le),kr(B,re),Ur(v,J,b)):de&lc?(kr(B,re),u.clip(De),Ur(v,J,b)):de&Do&&(u.save(),u.clip(De),Le&&u.clip(Le),kr(B,re),u.restore(),Ur(v,J,b)):(kr(B,re),Ur(v,J,b)),(me||Pe||De)&&u.restore()}function Ur(v,b,C){C>0&&(b instanceof Map?b.forEach((D,B)=>{u.strokeStyle=$e=B,u.stroke(D)}):b!=null&&v&&u.stroke(b))}function kr(v,b){b instanceof Map?b.forEach((C,D)=>{u.fillStyle=Xe=D,u.fill(C)}):b!=null&&v&&u.fill(b)}function Wm(v,b,C,D){let B=S[v],J;if(D<=0)J=[0,0];else{let re=B._space=B.space(n,v,b,C,D),de=B._incrs=B.incrs(n,v,b,C,D,re);J=e_(b,C,de,D,re)}return B._found=J}function Qa(v,b,C,D,B,J,re,de,me,Pe){let Le=re%2/2;_==1&&u.translate(Le,Le),mt(de,re,me,Pe,de),u.beginPath();let De,Ye,Mt,xt,ot=B+(D==0||D==3?-J:J);C==0?(Ye=B,xt=ot):(De=B,Mt=ot);for(let qe=0;qe<v.length;qe++)b[qe]!=null&&(C==0?De=Mt=v[qe]:Ye=xt=v[qe],u.moveTo(De,Ye),u.lineTo(Mt,xt));u.stroke(),_==1&&u.translate(-Le,-Le)}function $m(v){let b=!0;return S.forEach((C,D)=>{if(!C.show)return;let B=x[C.scale];if(B.min==null){C._show&&(b=!1,C._show=!1,Ks(!1));return}else C._show||(b=!1,C._show=!0,Ks(!1));let J=C.side,re=J%2,{min:de,max:me}=B,[Pe,Le]=Wm(D,de,me,re==0?ne:j);if(Le==0)return;let De=B.distr==2,Ye=C._splits=C.splits(n,D,de,me,Pe,Le,De),Mt=B.distr==2?Ye.map(Ve=>fe[Ve]):Ye,xt=B.distr==2?fe[Ye[1]]-fe[Ye[0]]:Pe,ot=C._values=C.values(n,C.filter(n,Mt,D,Le,xt),D,Le,xt);C._rotate=J==2?C.rotate(n,ot,D,Le):0;let qe=C._size;C._size=jn(C.size(n,ot,D,v)),qe!=null&&C._size!=qe&&(b=!1)}),b}function qm(v){let b=!0;return Ir.forEach((C,D)=>{let B=C(n,D,hi,v);B!=T[D]&&(b=!1),T[D]=B}),b}function Xm(){for(let v=0;v<S.length;v++){let b=S[v];if(!b.show||!b._show)continue;let C=b.side,D=C%2,B,J,re=b.stroke(n,v),de=C==0||C==3?-1:1,[me,Pe]=b._found;if(b.label!=null){let bn=b.labelGap*de,In=Zt((b._lpos+bn)*St);An(b.labelFont[0],re,"center",C==2?"top":pu),u.save(),D==1?(B=J=0,u.translate(In,Zt(Fe+Ee/2)),u.rotate((C==3?-ga:ga)/2)):(B=Zt(be+Be/2),J=In);let Ms=qf(b.label)?b.label(n,v,me,Pe):b.label;u.fillText(Ms,B,J),u.restore()}if(Pe==0)continue;let Le=x[b.scale],De=D==0?Be:Ee,Ye=D==0?be:Fe,Mt=b._splits,xt=Le.distr==2?Mt.map(bn=>fe[bn]):Mt,ot=Le.distr==2?fe[Mt[1]]-fe[Mt[0]]:me,qe=b.ticks,Ve=b.border,Ut=qe.show?qe.size:0,Ht=Zt(Ut*St),ln=Zt((b.alignTo==2?b._size-Ut-b.gap:b.gap)*St),At=b._rotate*-ga/180,Vt=p(b._pos*St),Nn=(Ht+ln)*de,xn=Vt+Nn;J=D==0?xn:0,B=D==1?xn:0;let Vn=b.font[0],Jn=b.align==1?oo:b.align==2?hl:At>0?oo:At<0?hl:D==0?"center":C==3?hl:oo,mi=At||D==1?"middle":C==2?"top":pu;An(Vn,re,Jn,mi);let Dn=b.font[1]*b.lineGap,Gn=Mt.map(bn=>p(a(bn,Le,De,Ye))),Qn=b._values;for(let bn=0;bn<Qn.length;bn++){let In=Qn[bn];if(In!=null){D==0?B=Gn[bn]:J=Gn[bn],In=""+In;let Ms=In.indexOf(`
`)==-1?[In]:In.split(/\n/gm);for(let yn=0;yn<Ms.length;yn++){let du=Ms[yn];At?(u.save(),u.translate(B,J+yn*Dn),u.rotate(At),u.fillText(du,0,0),u.restore()):u.fillText(du,B,J+yn*Dn)}}}qe.show&&Qa(Gn,qe.filter(n,xt,v,Pe,ot),D,C,Vt,Ht,Lt(qe.width*St,3),qe.stroke(n,v),qe.dash,qe.cap);let gi=b.grid;gi.show&&Qa(Gn,gi.filter(n,xt,v,Pe,ot),D,D==0?2:1,D==0?Fe:be,D==0?Ee:Be,Lt(gi.width*St,3),gi.stroke(n,v),gi.dash,gi.cap),Ve.show&&Qa([Vt],[1],D==0?1:0,D==0?1:2,D==1?Fe:be,D==1?Ee:Be,Lt(Ve.width*St,3),Ve.stroke(n,v),Ve.dash,Ve.cap)}an("drawAxes")}function Ks(v){M.forEach((b,C)=>{C>0&&(b._paths=null,v&&(s==1?(b.min=null,b.max=null):b.facets.forEach(D=>{D.min=null,D.max=null})))})}let Fr=!1,el=!1,Zo=[];function jm(){el=!1;for(let v=0;v<Zo.length;v++)an(...Zo[v]);Zo.length=0}function Zs(){Fr||(Xg(jh),Fr=!0)}function Ym(v,b=!1){Fr=!0,el=b,v(n),jh(),b&&Zo.length>0&&queueMicrotask(jm)}n.batch=Ym;function jh(){if(st&&(xs(),st=!1),pt&&(Je(),pt=!1),je){if(kt(m,oo,ie),kt(m,"top",Se),kt(m,ur,ne),kt(m,dr,j),kt(g,oo,ie),kt(g,"top",Se),kt(g,ur,ne),kt(g,dr,j),kt(d,ur,w),kt(d,dr,Q),h.width=Zt(w*St),h.height=Zt(Q*St),S.forEach(({_el:v,_show:b,_size:C,_pos:D,side:B})=>{if(v!=null)if(b){let J=B===3||B===0?C:0,re=B%2==1;kt(v,re?"left":"top",D-J),kt(v,re?"width":"height",C),kt(v,re?"top":"left",re?Se:ie),kt(v,re?"height":"width",re?j:ne),ic(v,Ds)}else Fn(v,Ds)}),$e=Xe=Ue=wt=Tt=sn=ut=ze=rt=null,Ot=1,er(!0),ie!=xe||Se!=Ae||ne!=Ke||j!=pe){Ks(!1);let v=ne/Ke,b=j/pe;if(ue&&!H&&ge.left>=0){ge.left*=v,ge.top*=b,Js&&_i(Js,Zt(ge.left),0,ne,j),Qs&&_i(Qs,0,Zt(ge.top),ne,j);for(let C=0;C<fn.length;C++){let D=fn[C];D!=null&&(Ai[C]*=v,Ri[C]*=b,_i(D,jn(Ai[C]),jn(Ri[C]),ne,j))}}if(It.show&&!ye&&It.left>=0&&It.width>0){It.left*=v,It.width*=v,It.top*=b,It.height*=b;for(let C in rl)kt(no,C,It[C])}xe=ie,Ae=Se,Ke=ne,pe=j}an("setSize"),je=!1}w>0&&Q>0&&(u.clearRect(0,0,h.width,h.height),an("drawClear"),I.forEach(v=>v()),an("draw")),It.show&&ye&&(Or(It),ye=!1),ue&&H&&(ys(null,!0,!1),H=!1),Me.show&&Me.live&&se&&(sl(),se=!1),l||(l=!0,n.status=1,an("ready")),we=!1,Fr=!1}n.redraw=(v,b)=>{pt=b||!1,v!==!1?ji(P,R.min,R.max):Zs()};function tl(v,b){let C=x[v];if(C.from==null){if(z==0){let D=C.range(n,b.min,b.max,v);b.min=D[0],b.max=D[1]}if(b.min>b.max){let D=b.min;b.min=b.max,b.max=D}if(z>1&&b.min!=null&&b.max!=null&&b.max-b.min<1e-16)return;v==P&&C.distr==2&&z>0&&(b.min=si(b.min,e[0]),b.max=si(b.max,e[0]),b.min==b.max&&b.max++),q[v]=b,st=!0,Zs()}}n.setScale=tl;let nl,il,Js,Qs,Yh,Kh,eo,to,Zh,Jh,Dt,Bt,Xi=!1;const hn=ge.drag;let on=hn.x,rn=hn.y;ue&&(ge.x&&(nl=qn(_g,g)),ge.y&&(il=qn(vg,g)),R.ori==0?(Js=nl,Qs=il):(Js=il,Qs=nl),Dt=ge.left,Bt=ge.top);const It=n.select=jt({show:!0,over:!0,left:0,width:0,top:0,height:0},i.select),no=It.show?qn(gg,It.over?g:m):null;function Or(v,b){if(It.show){for(let C in v)It[C]=v[C],C in rl&&kt(no,C,v[C]);b!==!1&&an("setSelect")}}n.setSelect=Or;function Km(v){if(M[v].show)oe&&ic(ke[v],Ds);else if(oe&&Fn(ke[v],Ds),ue){let C=Tn?fn[0]:fn[v];C!=null&&_i(C,-10,-10,ne,j)}}function ji(v,b,C){tl(v,{min:b,max:C})}function fi(v,b,C,D){b.focus!=null&&tg(v),b.show!=null&&M.forEach((B,J)=>{J>0&&(v==J||v==null)&&(B.show=b.show,Km(J),s==2?(ji(B.facets[0].scale,null,null),ji(B.facets[1].scale,null,null)):ji(B.scale,null,null),Zs())}),C!==!1&&an("setSeries",v,b),D&&tr("setSeries",n,v,b)}n.setSeries=fi;function Zm(v,b){jt(F[v],b)}function Jm(v,b){v.fill=at(v.fill||null),v.dir=bt(v.dir,-1),b=b??F.length,F.splice(b,0,v)}function Qm(v){v==null?F.length=0:F.splice(v,1)}n.addBand=Jm,n.setBand=Zm,n.delBand=Qm;function eg(v,b){M[v].alpha=b,ue&&fn[v]!=null&&(fn[v].style.opacity=b),oe&&ke[v]&&(ke[v].style.opacity=b)}let Ci,Yi,bs;const io={focus:!0};function tg(v){if(v!=bs){let b=v==null,C=Ln.alpha!=1;M.forEach((D,B)=>{if(s==1||B>0){let J=b||B==0||B==v;D._focus=b?null:J,C&&eg(B,J?1:Ln.alpha)}}),bs=v,C&&Zs()}}oe&&Ti&&Ne(vu,ce,v=>{ge._lock||(Kt(v),bs!=null&&fi(null,io,!0,$t.setSeries))});function pi(v,b,C){let D=x[b];C&&(v=v/St-(D.ori==1?Se:ie));let B=ne;D.ori==1&&(B=j,v=B-v),D.dir==-1&&(v=B-v);let J=D._min,re=D._max,de=v/B,me=J+(re-J)*de,Pe=D.distr;return Pe==3?Po(10,me):Pe==4?Ug(me,D.asinh):Pe==100?D.bwd(me):me}function ng(v,b){let C=pi(v,P,b);return si(C,e[0],K,Z)}n.valToIdx=v=>si(v,e[0]),n.posToIdx=ng,n.posToVal=pi,n.valToPos=(v,b,C)=>x[b].ori==0?o(v,x[b],C?Be:ne,C?be:0):r(v,x[b],C?Ee:j,C?Fe:0),n.setCursor=(v,b,C)=>{Dt=v.left,Bt=v.top,ys(null,b,C)};function Qh(v,b){kt(no,oo,It.left=v),kt(no,ur,It.width=b)}function eu(v,b){kt(no,"top",It.top=v),kt(no,dr,It.height=b)}let Jo=R.ori==0?Qh:eu,Qo=R.ori==1?Qh:eu;function ig(){if(oe&&Me.live)for(let v=s==2?1:0;v<M.length;v++){if(v==0&&ht)continue;let b=Me.values[v],C=0;for(let D in b)ct[v][C++].firstChild.nodeValue=b[D]}}function sl(v,b){if(v!=null&&(v.idxs?v.idxs.forEach((C,D)=>{_e[D]=C}):Bg(v.idx)||_e.fill(v.idx),Me.idx=_e[0]),oe&&Me.live){for(let C=0;C<M.length;C++)(C>0||s==1&&!ht)&&sg(C,_e[C]);ig()}se=!1,b!==!1&&an("setLegend")}n.setLegend=sl;function sg(v,b){let C=M[v],D=v==0&&V==2?fe:e[v],B;ht?B=C.values(n,v,b)??G:(B=C.value(n,b==null?null:D[b],v,b),B=B==null?G:{_:B}),Me.values[v]=B}function ys(v,b,C){Zh=Dt,Jh=Bt,[Dt,Bt]=ge.move(n,Dt,Bt),ge.left=Dt,ge.top=Bt,ue&&(Js&&_i(Js,Zt(Dt),0,ne,j),Qs&&_i(Qs,0,Zt(Bt),ne,j));let D,B=K>Z;Ci=Pt,Yi=null;let J=R.ori==0?ne:j,re=R.ori==1?ne:j;if(Dt<0||z==0||B){D=ge.idx=null;for(let de=0;de<M.length;de++){let me=fn[de];me!=null&&_i(me,-10,-10,ne,j)}Ti&&fi(null,io,!0,v==null&&$t.setSeries),Me.live&&(_e.fill(D),se=!0)}else{let de,me,Pe;s==1&&(de=R.ori==0?Dt:Bt,me=pi(de,P),D=ge.idx=si(me,e[0],K,Z),Pe=O(e[0][D],R,J,0));let Le=-10,De=-10,Ye=0,Mt=0,xt=!0,ot="",qe="";for(let Ve=s==2?1:0;Ve<M.length;Ve++){let Ut=M[Ve],Ht=_e[Ve],ln=Ht==null?null:s==1?e[Ve][Ht]:e[Ve][1][Ht],At=ge.dataIdx(n,Ve,D,me),Vt=At==null?null:s==1?e[Ve][At]:e[Ve][1][At];if(se=se||Vt!=ln||At!=Ht,_e[Ve]=At,Ve>0&&Ut.show){let Nn=At==null?-10:At==D?Pe:O(s==1?e[0][At]:e[Ve][0][At],R,J,0),xn=Vt==null?-10:$(Vt,s==1?x[Ut.scale]:x[Ut.facets[1].scale],re,0);if(Ti&&Vt!=null){let Vn=R.ori==1?Dt:Bt,Jn=Qt(Ln.dist(n,Ve,At,xn,Vn));if(Jn<Ci){let mi=Ln.bias;if(mi!=0){let Dn=pi(Vn,Ut.scale),Gn=Vt>=0?1:-1,Qn=Dn>=0?1:-1;Qn==Gn&&(Qn==1?mi==1?Vt>=Dn:Vt<=Dn:mi==1?Vt<=Dn:Vt>=Dn)&&(Ci=Jn,Yi=Ve)}else Ci=Jn,Yi=Ve}}if(se||Tn){let Vn,Jn;R.ori==0?(Vn=Nn,Jn=xn):(Vn=xn,Jn=Nn);let mi,Dn,Gn,Qn,gi,bn,In=!0,Ms=Nt.bbox;if(Ms!=null){In=!1;let yn=Ms(n,Ve);Gn=yn.left,Qn=yn.top,mi=yn.width,Dn=yn.height}else Gn=Vn,Qn=Jn,mi=Dn=Nt.size(n,Ve);if(bn=Nt.fill(n,Ve),gi=Nt.stroke(n,Ve),Tn)Ve==Yi&&Ci<=Ln.prox&&(Le=Gn,De=Qn,Ye=mi,Mt=Dn,xt=In,ot=bn,qe=gi);else{let yn=fn[Ve];yn!=null&&(Ai[Ve]=Gn,Ri[Ve]=Qn,Eu(yn,mi,Dn,In),Su(yn,bn,gi),_i(yn,jn(Gn),jn(Qn),ne,j))}}}}if(Tn){let Ve=Ln.prox,Ut=bs==null?Ci<=Ve:Ci>Ve||Yi!=bs;if(se||Ut){let Ht=fn[0];Ht!=null&&(Ai[0]=Le,Ri[0]=De,Eu(Ht,Ye,Mt,xt),Su(Ht,ot,qe),_i(Ht,jn(Le),jn(De),ne,j))}}}if(It.show&&Xi)if(v!=null){let[de,me]=$t.scales,[Pe,Le]=$t.match,[De,Ye]=v.cursor.sync.scales,Mt=v.cursor.drag;if(on=Mt._x,rn=Mt._y,on||rn){let{left:xt,top:ot,width:qe,height:Ve}=v.select,Ut=v.scales[De].ori,Ht=v.posToVal,ln,At,Vt,Nn,xn,Vn=de!=null&&Pe(de,De),Jn=me!=null&&Le(me,Ye);Vn&&on?(Ut==0?(ln=xt,At=qe):(ln=ot,At=Ve),Vt=x[de],Nn=O(Ht(ln,De),Vt,J,0),xn=O(Ht(ln+At,De),Vt,J,0),Jo(ri(Nn,xn),Qt(xn-Nn))):Jo(0,J),Jn&&rn?(Ut==1?(ln=xt,At=qe):(ln=ot,At=Ve),Vt=x[me],Nn=$(Ht(ln,Ye),Vt,re,0),xn=$(Ht(ln+At,Ye),Vt,re,0),Qo(ri(Nn,xn),Qt(xn-Nn))):Qo(0,re)}else al()}else{let de=Qt(Zh-Yh),me=Qt(Jh-Kh);if(R.ori==1){let Ye=de;de=me,me=Ye}on=hn.x&&de>=hn.dist,rn=hn.y&&me>=hn.dist;let Pe=hn.uni;Pe!=null?on&&rn&&(on=de>=Pe,rn=me>=Pe,!on&&!rn&&(me>de?rn=!0:on=!0)):hn.x&&hn.y&&(on||rn)&&(on=rn=!0);let Le,De;on&&(R.ori==0?(Le=eo,De=Dt):(Le=to,De=Bt),Jo(ri(Le,De),Qt(De-Le)),rn||Qo(0,re)),rn&&(R.ori==1?(Le=eo,De=Dt):(Le=to,De=Bt),Qo(ri(Le,De),Qt(De-Le)),on||Jo(0,J)),!on&&!rn&&(Jo(0,0),Qo(0,0))}if(hn._x=on,hn._y=rn,v==null){if(C){if(uu!=null){let[de,me]=$t.scales;$t.values[0]=de!=null?pi(R.ori==0?Dt:Bt,de):null,$t.values[1]=me!=null?pi(R.ori==1?Dt:Bt,me):null}tr(ul,n,Dt,Bt,ne,j,D)}if(Ti){let de=C&&$t.setSeries,me=Ln.prox;bs==null?Ci<=me&&fi(Yi,io,!0,de):Ci>me?fi(null,io,!0,de):Yi!=bs&&fi(Yi,io,!0,de)}}se&&(Me.idx=D,sl()),b!==!1&&an("setCursor")}let Ki=null;Object.defineProperty(n,"rect",{get(){return Ki==null&&er(!1),Ki}});function er(v=!1){v?Ki=null:(Ki=g.getBoundingClientRect(),an("syncRect",Ki))}function tu(v,b,C,D,B,J,re){ge._lock||Xi&&v!=null&&v.movementX==0&&v.movementY==0||(ol(v,b,C,D,B,J,re,!1,v!=null),v!=null?ys(null,!0,!0):ys(b,!0,!1))}function ol(v,b,C,D,B,J,re,de,me){if(Ki==null&&er(!1),Kt(v),v!=null)C=v.clientX-Ki.left,D=v.clientY-Ki.top;else{if(C<0||D<0){Dt=-10,Bt=-10;return}let[Pe,Le]=$t.scales,De=b.cursor.sync,[Ye,Mt]=De.values,[xt,ot]=De.scales,[qe,Ve]=$t.match,Ut=b.axes[0].side%2==1,Ht=R.ori==0?ne:j,ln=R.ori==1?ne:j,At=Ut?J:B,Vt=Ut?B:J,Nn=Ut?D:C,xn=Ut?C:D;if(xt!=null?C=qe(Pe,xt)?a(Ye,x[Pe],Ht,0):-10:C=Ht*(Nn/At),ot!=null?D=Ve(Le,ot)?a(Mt,x[Le],ln,0):-10:D=ln*(xn/Vt),R.ori==1){let Vn=C;C=D,D=Vn}}me&&(b==null||b.cursor.event.type==ul)&&((C<=1||C>=ne-1)&&(C=Ps(C,ne)),(D<=1||D>=j-1)&&(D=Ps(D,j))),de?(Yh=C,Kh=D,[eo,to]=ge.move(n,C,D)):(Dt=C,Bt=D)}const rl={width:0,height:0,left:0,top:0};function al(){Or(rl,!1)}let nu,iu,su,ou;function ru(v,b,C,D,B,J,re){Xi=!0,on=rn=hn._x=hn._y=!1,ol(v,b,C,D,B,J,re,!0,!1),v!=null&&(Ne(dl,tc,au,!1),tr(gu,n,eo,to,ne,j,null));let{left:de,top:me,width:Pe,height:Le}=It;nu=de,iu=me,su=Pe,ou=Le}function au(v,b,C,D,B,J,re){Xi=hn._x=hn._y=!1,ol(v,b,C,D,B,J,re,!1,!0);let{left:de,top:me,width:Pe,height:Le}=It,De=Pe>0||Le>0,Ye=nu!=de||iu!=me||su!=Pe||ou!=Le;if(De&&Ye&&Or(It),hn.setScale&&De&&Ye){let Mt=de,xt=Pe,ot=me,qe=Le;if(R.ori==1&&(Mt=me,xt=Le,ot=de,qe=Pe),on&&ji(P,pi(Mt,P),pi(Mt+xt,P)),rn)for(let Ve in x){let Ut=x[Ve];Ve!=P&&Ut.from==null&&Ut.min!=Pt&&ji(Ve,pi(ot+qe,Ve),pi(ot,Ve))}al()}else ge.lock&&(ge._lock=!ge._lock,ys(b,!0,v!=null));v!=null&&(L(dl,tc),tr(dl,n,Dt,Bt,ne,j,null))}function og(v,b,C,D,B,J,re){if(ge._lock)return;Kt(v);let de=Xi;if(Xi){let me=!0,Pe=!0,Le=10,De,Ye;R.ori==0?(De=on,Ye=rn):(De=rn,Ye=on),De&&Ye&&(me=Dt<=Le||Dt>=ne-Le,Pe=Bt<=Le||Bt>=j-Le),De&&me&&(Dt=Dt<eo?0:ne),Ye&&Pe&&(Bt=Bt<to?0:j),ys(null,!0,!0),Xi=!1}Dt=-10,Bt=-10,_e.fill(null),ys(null,!0,!0),de&&(Xi=de)}function lu(v,b,C,D,B,J,re){ge._lock||(Kt(v),Ie(),al(),v!=null&&tr(xu,n,Dt,Bt,ne,j,null))}function cu(){S.forEach(t_),ae(n.width,n.height,!0)}Bs(Ta,To,cu);const so={};so.mousedown=ru,so.mousemove=tu,so.mouseup=au,so.dblclick=lu,so.setSeries=(v,b,C,D)=>{let B=$t.match[2];C=B(n,b,C),C!=-1&&fi(C,D,!0,!1)},ue&&(Ne(gu,g,ru),Ne(ul,g,tu),Ne(_u,g,v=>{Kt(v),er(!1)}),Ne(vu,g,og),Ne(xu,g,lu),cc.add(n),n.syncRect=er);const Br=n.hooks=i.hooks||{};function an(v,b,C){el?Zo.push([v,b,C]):v in Br&&Br[v].forEach(D=>{D.call(null,n,b,C)})}(i.plugins||[]).forEach(v=>{for(let b in v.hooks)Br[b]=(Br[b]||[]).concat(v.hooks[b])});const hu=(v,b,C)=>C,$t=jt({key:null,setSeries:!1,filters:{pub:Pu,sub:Pu},scales:[P,M[1]?M[1].scale:null],match:[Lu,Lu,hu],values:[null,null]},ge.sync);$t.match.length==2&&$t.match.push(hu),ge.sync=$t;const uu=$t.key,ll=gp(uu);function tr(v,b,C,D,B,J,re){$t.filters.pub(v,b,C,D,B,J,re)&&ll.pub(v,b,C,D,B,J,re)}ll.sub(n);function rg(v,b,C,D,B,J,re){$t.filters.sub(v,b,C,D,B,J,re)&&so[v](null,b,C,D,B,J,re)}n.pub=rg;function ag(){ll.unsub(n),cc.delete(n),ft.clear(),sc(Ta,To,cu),c.remove(),ce?.remove(),an("destroy")}n.destroy=ag;function cl(){an("init",i,e),Oe(e||i.data,!1),q[P]?tl(P,q[P]):Ie(),ye=It.show&&(It.width>0||It.height>0),H=se=!0,ae(i.width,i.height)}return M.forEach(Ko),S.forEach(Ja),t?t instanceof HTMLElement?(t.appendChild(c),cl()):t(n,cl):cl(),n}_n.assign=jt;_n.fmtNum=uh;_n.rangeNum=Aa;_n.rangeLog=za;_n.rangeAsinh=ch;_n.orient=qs;_n.pxRatio=St;_n.join=qg;_n.fmtDate=fh,_n.tzDate=i0;_n.sync=gp;{_n.addGap=B0,_n.clipGaps=Ga;let i=_n.paths={points:Mp};i.linear=wp,i.stepped=V0,i.bars=G0,i.spline=$0}const n_="Hand in",i_="To hand in: press Stand up, push the robot, then Hand in within a minute, and change nothing else in between. It saves a file on this device: give it to your teacher.",s_="This robot's electronics are a file of their own: a hand-in of it cannot be run again.",o_="There is no run to hand in: press Stand up, push the robot, then hand in within a minute.",r_=".",a_="Certify",l_="{text}",c_="Results as CSV",h_="To join the class",u_="English",d_="upright lab",f_="Skip to the controls",p_="Connecting …",m_="The simulation is starting …",g_="Live",__="No connection; trying again",v_="Recording",x_="This page has stopped",b_="Light or dark",y_="What the buttons, keys and mouse do",M_="Close",S_="The robot in its room. Drag its body to push it; drag the floor to change the view.",w_="{body} leans {pitch} degrees and has rolled {way} centimetres.",E_="{body} has fallen.",T_="twin",A_="nonlinear model",R_="linear model",C_="published model",P_="calibrated model",L_="The robot as MuJoCo simulates it, with contact and friction: it stands for the hardware",N_="The full equations of motion of the model, without contact",D_="The same model, linearised about upright: valid for small angles",I_="The model with the equations as they were published",U_="The model with the parameters that Calibrate has found",k_="It balances by itself: drag it to push it",F_="More curves",O_="Fewer curves",B_="robot: {body}",z_="knock {size} N s",H_="held from the front",V_="held from behind",G_="pulled left",W_="pulled right",$_="push {size} N s",q_="push",X_="stood up",j_="best knock {best} N s",Y_="The largest single knock, or push by hand of at most half a second, that it has recovered from. A longer push holds the robot and does not count. Nor does one that comes before it has recovered from another.",K_="Push a robot on two wheels, and see what keeps it upright",Z_="New here? Take the tour",J_="1000 robots, each a little different, are held, released and knocked in simulation: about half a minute.",Q_="The parameters with which the model predicts the log best are searched.",ev="The log is searched for faults of units, signs, time and sensors.",tv="It begins soon; jobs run one at a time.",nv="{seconds} s so far",iv="about {seconds} s left",sv="{seconds} s so far, longer than expected",ov="300 robots, each a little different, are pushed in simulation. This takes a few seconds.",rv="It fell.",av="Stand up",lv="Tilt",cv="The robot stands up again, tilted by 0.1 rad (6°), and is let go",hv="Pause",uv="Play",dv="One step",fv="While paused: goes on by one step of the controller, some thousandths of a second",pv="Speed",mv="Back in time",gv="Time",_v="It lies; press Stand up first.",vv="now",xv="Pushes",bv="Hold from the front",yv="A force on the front that holds a lean of +0.1 rad for 3 s and is then released (the paper's first push)",Mv="Hold from behind",Sv="A force on the back that holds a lean of −0.12 rad for 3 s and is then released (the paper's second push)",wv="Knock",Ev="A short blow to the body, of the size beside it (K)",Tv="Pull left",Av="Pull right",Rv="Pull left, Pull right",Cv="A pull at one wheel for 0.3 s, a quarter of the robot's weight: it turns",Pv="Size",Lv="Force times time: 0.05 N s is what an apple of 100 g brings at half a metre per second",Nv="Arrow keys drive and turn",Dv="pitch",Iv="pitch rate",Uv="wheel angle",kv="wheel rate",Fv="yaw",Ov="yaw rate",Bv="Traces of the last seconds",zv="Seconds shown",Hv="Settings, views and files",Vv="Controller",Gv="Robot",Wv="Kit",$v="See",qv="Identify",Xv="Keep",jv="Tour",Yv="Class",Kv="Method",Zv="LQG: Kalman filter with dead time",Jv="LQR with a Kalman filter",Qv="LQI: LQG with an integral of the wheel angle",ex="PID cascade",tx="H∞",nx="MPC: predictive, keeps limits",ix="Sliding mode",sx="Robust: one gain for many robots",ox="Gains by hand: u = −K x",rx="No controller",ax="There is no controller, so there is no loop.",lx="Largest accepted deviations (Bryson's rule): smaller means stricter",cx="command",hx="Back to the default weights",ux="This method has no weights to set here.",dx="How strict this controller is was fixed when it was designed. To change something here, choose Gains by hand. In the live lab (upright lab, with Python) you can set how strict it is.",fx="Designing …",px="A robust design takes some ten seconds.",mx="Gain K on the left motor",gx="Gain K",_x="If only both motors change together",vx="(not the weakest place)",xx="u = −K x, in {unit}. ψ pitch, θ wheel angle and φ yaw are in rad; a dot marks their rates, in rad/s.",bx="gain factor",yx="phase",Mx="more delay",Sx="The loop bears {delay} ms more delay at its weakest place ({place}); at least {least} ms are needed.",wx="It bears signals that are {down} % weaker ({low}) or {up} % stronger ({high}); at least 4 % is needed.",Ex="It bears signals that are {down} % weaker ({low}), or as strong as they like.",Tx="The loop bears any delay.",Ax="The margins suffice, but the certificate is red.",Rx="The margins suffice, but the certificate is amber.",Cx="Already at the motors the margins are thin.",Px="Not only the motors count, but every sensor, too: the smallest margin of all places is being computed …",Lx="Not only the motors count, but every sensor, too: the smallest margin of all places is part of the certificate.",Nx="Not only the motors count, but every sensor, too: the live lab computes the smallest margin of all places.",Dx="Saved; to save again:",Ix="Link copied. It opens this page on this computer; for others, put the page on a web host.",Ux="lean {size} rad",kx="There is no certificate in this page: the tab Python has its command.",Fx="The margins suffice.",Ox="The margins are thin.",Bx="unlimited",zx="Certificate",Hx="green, fit for the real robot",Vx="amber, with care",Gx="red, not fit for the real robot",Wx="computing …",$x="none",qx="red, no controller",Xx="This page has no robot '{name}'; it shows {shown}. It has: {all}.",jx="This page leaves parts of the link out: {parts}.",Yx="This page has no controller '{name}' for this robot; it shows {shown}. It has: {all}.",Kx="The full certificate is ready. It stands in the tab Identify, too.",Zx="Full certificate",Jx="Robot",Qx="Open robot.toml",eb="Parameters",tb="The controller is designed for these parameters.",nb="Back to the preset's parameters",ib="Payload unknown to the controller",sb="Height of the payload above the axle",ob="Slope of the floor",rb="Grip of the wheels, coefficient of friction (twin)",ab="Bodies to compare",lb="Electronics",cb="ideal: nothing between controller and motors",hb="Noise, rounding and bias of the sensors",ub="Dead time from sensor to motor",db="Battery",fb="Dead zone of the motors",pb="Back to the kit's values",mb="Loop: margins, Bode, Nyquist, poles",gb="What to see",_b="Bode plot of the loop broken at both motors",vb="Nyquist plot",xb="Closed-loop poles",bb="Phase portrait",yb="Voltage",Mb="Voltage at the left and right motor; bars mark saturation.",Sb="Torque of the left and right motor; bars mark saturation.",wb="Estimate",Eb="The controller's estimate of the pitch, and the true pitch.",Tb="This controller estimates no state: it reads the true state, or nothing.",Ab="Equations",Rb="v in volts, or in the unit of the torque. Dry and rolling friction, slope and pushes are added to these.",Cb="left",Pb="right",Lb="truth",Nb="estimate",Db="saturated",Ib="Linearised about upright, ẋ = A x + B u",Ub="Open-loop poles",kb="Log to use",Fb="this run (the last minute)",Ob="Open a log",Bb="Doctor",zb="Finds faults of the log: units, signs, delays, bias …",Hb="Calibrate",Vb="Estimates the robot's parameters from its raw sensors; the calibrated model is shown as a further trace",Gb="Compare",Wb="A page with numbers and figures of all bodies over the last minute, and of the opened log",$b="Stop",qb="The comparison is being made.",Xb="Another job is still running; the comparison may take longer.",jb="Doctor: finds faults of the log. Calibrate: finds the robot's parameters in it; push and drive the robot for half a minute first, it then computes for some ten seconds to two minutes. Compare: a page of numbers and figures of all bodies.",Yb="Log",Kb="The files hold the run since the last change, at most the last minute.",Zb="Data, for a spreadsheet or for upright",Jb="Pages: numbers and figures, or the run to be seen again",Qb="Files, for the commands of upright",ey="To show it: a picture, or a link to this set-up",ty="Log as CSV: what the curves show, at most the last minute, for a spreadsheet or for upright. Picture: the robot as you see it now.",ny="A report and a replay page need Python: the live lab (upright lab) makes them.",iy="Log as CSV",sy="Log as Parquet",oy="Report",ry="Replay page",ay="Controller file",ly="Robot file",cy="Picture",hy="Copy link",uy="Link copied. It restores this whole set-up.",dy="It carries no push.",fy="It repeats the last push.",py="Your push by hand is in it as a knock of the same impulse.",my="Your push by hand was too long to be in it.",gy="{name} is ready",_y="Recovered from a push of {impulse} N s; largest so far {best} N s",vy="Recovered from a push of {impulse} N s, the largest so far",xy="It recovered, but not from a single push: no record.",by="It fell after a push of {impulse} N s.",yy="It fell after {impulse} N s of pushes.",My="Reading {name}",Sy="force {force} N",wy="Board",Ey="Name",Ty="Largest push [N s]",Ay="Effort",Ry="Send my set-up to everyone",Cy="Your name",Py="Type your name first.",Ly="Token",Ny="Join",Dy="Join the class",Iy="Step {n} of {all}",Uy="Do",ky="Watch",Fy="Think",Oy="Prepare",By="Next",zy="Back to my robot",Hy=", without the payload",Vy=", on a level floor",Gy="Writing the file",Wy="Previous",$y=[["Mouse on the robot","drag and hold to push"],["Mouse on the floor","drag to change the view, scroll to zoom"],["One finger","on the robot: push it; beside it: change the view, sideways"],["← → ↑ ↓","turn and drive; a gamepad's left stick does the same"],["F, B","push from the front, from the back, while the key is held"],["K","knock"],["Space","pause and continue"],[".","one step"],[", and /","back and forth in time, while paused"],["S","stand up"],["1, 2, 3 …","open the first, second, third … tab"],["N, P","next and previous step of the tour; Enter sets it up"],["[ ] { } + −","change the view and zoom, while the room has the focus"],["?","this list"]],qy="Python",Xy="Linear model as a ghost beside the robot",jy="Payload unknown to the controller: {mass} g, {height} cm above the axle",Yy="The controller stays as it was designed, for a level floor and the kit as it is.",Ky="Copy link",Zy="A link to this robot and controller, and to the last push; a short one by hand becomes a knock",Jy="Link copied. Whoever opens it sees this robot and this controller.",Qy="This page runs by itself. What follows needs upright on a computer with Python 3.11 or newer. Install it once, in the unpacked folder of upright:",eM="pip install .",tM="Copy",nM="Copied.",iM=[["A log of the twin of this robot, which holds against a push","upright simulate -r {robot} -b twin -c {controller} -p hold:0.1,until=1 -o run.csv"],["Calibrate a robot from its log","upright calibrate run.csv --robot {robot}"],["Design this controller, with its margins, and save it","upright design {controller} -r {robot} -o controller.json"],["Certify this controller","upright certify {controller} -r {robot}"],["Your own robot, from a file, in a page like this","upright lab --export site --robot mine.toml"],["The live lab, with the MuJoCo twin, payloads, other electronics and every parameter","upright lab"]],sM=[{title:"Push it",do:"Press Knock. Or drag the robot with the mouse or a finger, and let go.",watch:"The wheels roll under the body, and its lean ψ comes back to zero: 0.1 rad is 6°. θ is the angle of the wheels. Before the first push it may stand quite still: the motors do not answer to small voltages. Once it moves it goes on to sway a little, because of that and of the noise of the sensors.",ask:"How large a knock can it bear? The slider Size sets it. The robot is the twin, which MuJoCo simulates in place of the hardware; the pale ghosts are simpler models. Where do their curves differ in the second after the knock?",here:{watch:"The wheels roll under the body, and its lean ψ comes back to zero: 0.1 rad is 6°. θ is the angle of the wheels. Before the first push it may stand quite still: the motors do not answer to small voltages. Once it moves it goes on to sway a little, because of that and of the noise of the sensors.",ask:"How large a knock can it bear? The slider Size sets it. The pale ghost beside the robot is a simpler, linear model: where does its curve differ in the second after the knock?"}},{title:"It falls by itself",do:"Press Prepare: nothing controls the robot then. It starts with a lean of 0.02 rad.",watch:"ψ grows like an exponential, because one open-loop pole lies in the right half-plane.",ask:"How long until the lean has doubled? Compare with ln 2 divided by the unstable pole (See, Equations)."},{title:"Linearise",do:"Press Prepare: only the two models start, without a controller, from a small lean.",watch:"Run it slowly. The pitch ψ of both models agrees almost down to the floor. The wheel angle θ separates earlier.",ask:"Which terms does the linear model approximate? Look at sin ψ and cos ψ. Why does θ show it before ψ?"},{title:"Regulate",do:"Press Prepare: an LQR balances it now. Tilt it, and change the accepted pitch under Controller.",watch:"A smaller accepted pitch makes a larger gain: quicker return, more voltage. Tilted, it leans further at first, until its sensors show the lean.",ask:"How do the margins change when the accepted pitch gets smaller? What is the price of a quick return?",here:{do:"Press Prepare: an LQR balances it now. Tilt it. Then choose Gains by hand under Controller, and move ψ pitch → u a little.",watch:"The gain on ψ is negative. Further from 0 it asks for more voltage; much further, or nearer to 0, the margins shrink and it swings for long. Tilted, it leans further at first, until its sensors show the lean.",ask:"How do the margins change with the gain on ψ? What is the price of a quick return?"}},{title:"Push the front",do:"Press Prepare: after a second a force on the front holds ψ at 0.1 rad, and is then released.",watch:"The robot leans into the force. After the release it rolls, overshoots and comes back.",ask:"Why does a push on the front hold a forward lean? Think of the sum of moments."},{title:"Push the back",do:"Press Prepare: after a second a force from behind holds −0.12 rad, and is then released.",watch:"The same response, mirrored and a little larger. φ, under More curves, hardly moves.",ask:"Is the response exactly the mirror image? What would make the two sides differ?"},{title:"Compare",do:"Press Prepare: twin and models are held in the same way, and released. When they stand again, open Identify and press Compare.",watch:"Shapes agree, settling times differ: the linear model settles differently from the others.",ask:"Which of the signals differs most, and which physical effect is behind it?"},{title:"Break the linear model",do:"Press Prepare: the robot carries a payload that neither the controller nor the linear model includes. Knock it gently, then harder.",watch:"After a gentle knock the linear ghost comes to rest, and the twin goes on to sway widely. At 0.3 N s the ghost, which has no payload, falls first.",ask:"How large a payload does the margin allow? Find the limit.",here:{watch:"After a gentle knock the linear ghost comes to rest, and the robot goes on to sway widely. At 0.3 N s the ghost, which has no payload, falls first.",ask:"Can gains by hand carry the payload? Try it."}},{title:"Make it robust",do:"Press Prepare: a robust design has one gain for many robots. Repeat your pushes.",watch:"It keeps its margins for robots that differ, but need not bear a larger knock. The light of the certificate shows the risk.",ask:"Does it bear more than the regulator before? What did robustness cost? Compare effort and travel in a report."}],oM="This robot cannot be simulated. The one before it stands here again.",rM="That was too much at once: some of it was left out. Wait a moment.",aM="The simulation stopped and was started again. All robots stand upright.",lM="Your last change stopped the simulation for all. The usual robot stands here instead.",Er={handIn:n_,handInNote:i_,noReplay:s_,noRun:o_,decimal:r_,certify:a_,original:l_,results:c_,invite:h_,language:u_,title:d_,skip:f_,connecting:p_,starting:m_,connected:g_,lost:__,replaying:v_,refused:x_,theme:b_,help:y_,close:M_,scene:S_,sceneNow:w_,fellNow:E_,twin:T_,nonlinear:A_,linear:R_,published:C_,calibrated:P_,twinNote:L_,nonlinearNote:N_,linearNote:D_,publishedNote:I_,calibratedNote:U_,hint:k_,moreCurves:F_,fewerCurves:O_,robotIs:B_,mark_impulse:z_,mark_front:H_,mark_back:V_,mark_pull_left:G_,mark_pull_right:W_,mark_hand:$_,mark_held:q_,mark_stood:X_,best:j_,bestTip:Y_,what:K_,newHere:Z_,doing_certify:J_,doing_calibrate:Q_,doing_doctor:ev,oneAtATime:tv,soFar:nv,stillTakes:iv,overdue:sv,lightNote:ov,fallen:rv,standUp:av,tilt:lv,tiltTip:cv,pause:hv,play:uv,step:dv,stepTip:fv,speed:pv,back:mv,timeLine:gv,lies:_v,now:vv,pushes:xv,front:bv,frontTip:yv,backPush:Mv,backTip:Sv,impulse:wv,impulseTip:Ev,pullLeft:Tv,pullRight:Av,pullBoth:Rv,pullTip:Cv,size:Pv,sizeTip:Lv,drive:Nv,pitch:Dv,pitch_rate:Iv,wheel:Uv,wheel_rate:kv,yaw:Fv,yaw_rate:Ov,charts:Bv,window:zv,tabs:Hv,tabController:Vv,tabRobot:Gv,tabKit:Wv,tabSee:$v,tabIdentify:qv,tabKeep:Xv,tabTour:jv,tabClass:Yv,family:Kv,lqg:Zv,lqr:Jv,"lqr-complementary":"LQR with a complementary filter","lqr-state":"LQR on the true state (simulation only)",lqi:Qv,pid:ex,hinf:tx,mpc:nx,sliding:ix,robust:sx,gains:ox,off:rx,noLoop:ax,weights:lx,command:cx,ownWeights:hx,noWeights:ux,fixedWeights:dx,designing:fx,robustTakes:px,gain:mx,gainBoth:gx,margins:_x,notWeakest:vx,gainNote:xx,gainMargin:bx,phaseMargin:yx,delayMargin:Mx,leastDelay:Sx,leastGain:wx,leastGainLow:Ex,anyDelay:Tx,enoughRed:Ax,enoughAmber:Rx,thinMotors:Cx,placesPending:Px,placesCertificate:Lx,placesPython:Nx,saved:Dx,lookHere:Ix,mark_tilt:Ux,noCertificateHere:kx,enough:Fx,thin:Ox,unlimited:Bx,certificate:zx,green:Hx,amber:Vx,red:Gx,none:Wx,noCertificate:$x,noneRed:qx,noSuchRobot:Xx,leftOut:jx,noSuchController:Yx,certified:Kx,fullCertificate:Zx,preset:Jx,openRobot:Qx,numbers:eb,numbersNote:tb,ownNumbers:nb,payload:ib,payloadHeight:sb,slope:ob,grip:rb,bodies:ab,kit:lb,ideal:cb,noise:hb,delay:ub,voltage:db,deadZone:fb,ownKit:pb,loop:mb,viewLabel:gb,bode:_b,nyquist:vb,poles:xb,portrait:bb,voltages:yb,voltagesNote:Mb,torquesNote:Sb,estimate:wb,estimateNote:Eb,noEstimate:Tb,equations:Ab,equationsNote:Rb,leftMotor:Cb,rightMotor:Pb,truth:Lb,opinion:Nb,saturated:Db,linearised:Ib,openPoles:Ub,source:kb,thisRun:Fb,openLog:Ob,doctor:Bb,doctorTip:zb,calibrate:Hb,calibrateTip:Vb,compare:Gb,compareTip:Wb,stop:$b,comparing:qb,compareWaits:Xb,calibrateNote:jb,log:Yb,keepNote:Kb,keepData:Zb,keepPages:Jb,keepFiles:Qb,keepShow:ey,csvNote:ty,keepLive:ny,csv:iy,parquet:sy,report:oy,replay:ry,controllerFile:ay,robotFile:ly,picture:cy,link:hy,linkCopied:uy,noPush:dy,namedPush:fy,knockPush:py,heldPush:my,made:gy,recovered:_y,recoveredMost:vy,recoveredSeveral:xy,lostPush:by,lostPushes:yy,uploaded:My,newtons:Sy,board:wy,name:Ey,bestPush:Ty,effort:Ay,broadcast:Ry,yourName:Cy,nameMissing:Py,token:Ly,enter:Ny,joinTitle:Dy,tourStep:Iy,tourDo:Uy,tourWatch:ky,tourAsk:Fy,tourSet:Oy,next:By,tourBack:zy,butPayload:Hy,butSlope:Vy,writing:Gy,previous:Wy,keys:$y,tabPython:qy,ghost:Xy,carries:jy,stays:Yy,lookAtThis:Ky,lookTip:Zy,lookCopied:Jy,pythonNote:Qy,install:eM,copy:tM,copied:nM,python:iM,tour:sM,setBack:oM,tooMany:rM,restarted:aM,ended:lM},cM="Entregar",hM="Para entregar: presione Poner de pie, empuje el robot y presione Entregar antes de un minuto, sin cambiar nada más. Guarda un archivo en este equipo: déselo a su docente.",uM="La electrónica de este robot es un archivo propio: su entrega no se puede repetir.",dM="No hay nada que entregar: presione Poner de pie, empuje el robot y entregue antes de un minuto.",fM=",",pM="Certificar",mM="Mensaje original: {text}",gM="Resultados en CSV",_M="Para unirse a la clase",vM="Español",xM="upright lab",bM="Ir a los controles",yM="Conectando …",MM="La simulación está arrancando …",SM="En vivo",wM="Sin conexión; se intenta de nuevo",EM="Grabación",TM="Esta página se ha detenido",AM="Claro u oscuro",RM="Qué hacen los botones, las teclas y el mouse",CM="Cerrar",PM="El robot en su sala. Arrastre su cuerpo para empujarlo; arrastre el suelo para cambiar la vista.",LM="{body} se inclina {pitch} grados y ha rodado {way} centímetros.",NM="{body} se ha caído.",DM="gemelo",IM="modelo no lineal",UM="modelo lineal",kM="modelo publicado",FM="modelo calibrado",OM="El robot como lo simula MuJoCo, con contacto y fricción: hace las veces del robot real",BM="Las ecuaciones de movimiento completas del modelo, sin contacto",zM="El mismo modelo, linealizado en vertical: válido para ángulos pequeños",HM="El modelo con las ecuaciones tal como se publicaron",VM="El modelo con los parámetros que encontró Calibrar",GM="Se equilibra solo: arrástrelo para empujarlo",WM="Más curvas",$M="Menos curvas",qM="robot: {body}",XM="golpe {size} N s",jM="sostenido por delante",YM="sostenido por detrás",KM="tirón izquierdo",ZM="tirón derecho",JM="empujón {size} N s",QM="empujón",eS="de pie",tS="mejor golpe {best} N s",nS="El mayor golpe solo, o empujón a mano de medio segundo como máximo, del que se recuperó. Un empujón más largo sostiene el robot y no cuenta. Tampoco uno dado antes de que se recupere de otro.",iS="Empuje un robot de dos ruedas y vea qué lo mantiene en pie",sS="¿Primera vez? Haga el recorrido",oS="1000 robots, cada uno algo distinto, se sostienen, se sueltan y reciben golpes en simulación: cerca de medio minuto.",rS="Se buscan los parámetros con los que el modelo predice mejor el registro.",aS="Se buscan fallos de unidades, signos, tiempo y sensores en el registro.",lS="Empieza pronto; los trabajos se hacen uno tras otro.",cS="{seconds} s hasta ahora",hS="faltan unos {seconds} s",uS="{seconds} s hasta ahora, más de lo previsto",dS="300 robots, cada uno algo distinto, reciben empujones en simulación. Tarda unos segundos.",fS="Se cayó.",pS="Poner de pie",mS="Inclinar",gS="El robot se pone de pie otra vez, inclinado 0,1 rad (6°), y se suelta",_S="Pausa",vS="Continuar",xS="Un paso",bS="En pausa: avanza un paso del controlador, unas milésimas de segundo",yS="Velocidad",MS="Atrás en el tiempo",SS="Tiempo",wS="Está caído; presione antes Poner de pie.",ES="ahora",TS="Empujones",AS="Sostener por delante",RS="Una fuerza por delante que mantiene +0,1 rad durante 3 s y luego cesa (el primer empujón del artículo)",CS="Sostener por detrás",PS="Una fuerza por detrás que mantiene −0,12 rad durante 3 s y luego cesa (el segundo empujón del artículo)",LS="Dar un golpe",NS="Un golpe breve al cuerpo, del tamaño que está al lado (K)",DS="Tirón izq.",IS="Tirón der.",US="Tirón izq., Tirón der.",kS="Un tirón de una rueda durante 0,3 s, de un cuarto del peso del robot: gira",FS="Tamaño",OS="Fuerza por tiempo: 0,05 N s es lo que trae una manzana de 100 g a medio metro por segundo",BS="Las flechas conducen y giran",zS="inclinación",HS="velocidad de inclinación",VS="ángulo de ruedas",GS="velocidad de ruedas",WS="rumbo",$S="velocidad de giro",qS="Trazas de los últimos segundos",XS="Segundos mostrados",jS="Ajustes, vistas y archivos",YS="Controlador",KS="Robot",ZS="Electrónica",JS="Ver",QS="Identificar",ew="Guardar",tw="Recorrido",nw="Clase",iw="Método",sw="LQG: filtro de Kalman con retardo",ow="LQR con filtro de Kalman",rw="LQI: LQG con integral del ángulo de ruedas",aw="PID en cascada",lw="H∞",cw="MPC: predictivo, respeta límites",hw="Modo deslizante",uw="Robusto: una ganancia para muchos robots",dw="Ganancias a mano: u = −K x",fw="Sin controlador",pw="No hay controlador, así que no hay lazo.",mw="Mayores desviaciones aceptadas (regla de Bryson): menor es más estricto",gw="mando",_w="Volver a los pesos predeterminados",vw="Este método no tiene pesos que ajustar aquí.",xw="Lo estricto que es este controlador quedó fijado al diseñarlo. Para cambiar algo aquí, elija Ganancias a mano. En el laboratorio en vivo (upright lab, con Python) también se puede cambiar eso.",bw="Diseñando …",yw="Un diseño robusto tarda unos diez segundos.",Mw="Ganancia K del motor izquierdo",Sw="Ganancia K",ww="Si solo cambian ambos motores a la vez",Ew="(no es el punto más débil)",Tw="u = −K x, en {unit}. ψ inclinación, θ ángulo de rueda y φ rumbo van en rad; el punto marca su velocidad, en rad/s.",Aw="factor de ganancia",Rw="fase",Cw="más retardo",Pw="En su punto más débil ({place}) el lazo soporta {delay} ms más de retardo; se piden al menos {least} ms.",Lw="Soporta señales un {down} % más débiles ({low}) o un {up} % más fuertes ({high}); se pide al menos un 4 %.",Nw="Soporta señales un {down} % más débiles ({low}), o tan fuertes como se quiera.",Dw="El lazo soporta cualquier retardo.",Iw="Los márgenes bastan, pero el certificado es rojo.",Uw="Los márgenes bastan, pero el certificado es ámbar.",kw="Ya en los motores los márgenes son escasos.",Fw="No solo cuentan los motores, también cada sensor: se está calculando el margen más pequeño de todos los puntos …",Ow="No solo cuentan los motores, también cada sensor: el margen más pequeño de todos los puntos es parte del certificado.",Bw="No solo cuentan los motores, también cada sensor: el laboratorio en vivo calcula el margen más pequeño de todos los puntos.",zw="Guardado; para guardarlo otra vez:",Hw="Enlace copiado. Abre esta página en este computador; para otras personas, póngala en un servidor web.",Vw="inclinación {size} rad",Gw="En esta página no hay certificado: la pestaña Python tiene su comando.",Ww="Los márgenes bastan.",$w="Los márgenes son escasos.",qw="sin límite",Xw="Certificado",jw="verde, apto para el robot real",Yw="ámbar, con cuidado",Kw="rojo, no apto para el robot real",Zw="calculando …",Jw="ninguno",Qw="rojo, sin controlador",e1="Esta página no tiene el robot '{name}'; muestra {shown}. Tiene: {all}.",t1="Esta página deja fuera partes del enlace: {parts}.",n1="Esta página no tiene el controlador '{name}' para este robot; muestra {shown}. Tiene: {all}.",i1="El certificado completo está listo. También está en la pestaña Identificar.",s1="Certificado completo",o1="Robot",r1="Abrir robot.toml",a1="Parámetros",l1="El controlador se diseña para estos parámetros.",c1="Volver a los parámetros del preajuste",h1="Carga que el controlador desconoce",u1="Altura de la carga sobre el eje",d1="Pendiente del suelo",f1="Agarre de las ruedas, coeficiente de fricción (gemelo)",p1="Cuerpos",m1="Electrónica",g1="ideal: nada entre controlador y motores",_1="Ruido, redondeo y sesgo de los sensores",v1="Retardo del sensor al motor",x1="Batería",b1="Zona muerta de los motores",y1="Volver a los valores de la electrónica",M1="Lazo: márgenes, Bode, Nyquist, polos",S1="Qué se ve",w1="Diagrama de Bode del lazo abierto en ambos motores",E1="Diagrama de Nyquist",T1="Polos en lazo cerrado",A1="Plano de fase",R1="Tensión",C1="Tensión en el motor izquierdo y en el derecho; las barras marcan saturación.",P1="Par del motor izquierdo y del derecho; las barras marcan saturación.",L1="Estimación",N1="La inclinación estimada por el controlador y la verdadera.",D1="Este controlador no estima el estado: lee el verdadero, o nada.",I1="Ecuaciones",U1="v en voltios, o en la unidad del par. A esto se suman fricción seca y de rodadura, pendiente y empujones.",k1="izquierdo",F1="derecho",O1="verdad",B1="estimación",z1="saturado",H1="Linealizado en vertical, ẋ = A x + B u",V1="Polos en lazo abierto",G1="Registro que se usa",W1="este ensayo (el último minuto)",$1="Abrir un registro",q1="Doctor",X1="Busca fallos del registro: unidades, signos, retardos, sesgo …",j1="Calibrar",Y1="Estima los parámetros del robot a partir de sus sensores; el modelo calibrado se muestra como otra traza",K1="Comparar",Z1="Una página con números y figuras de todos los cuerpos en el último minuto, y del registro abierto",J1="Parar",Q1="Se está haciendo la comparación.",eE="Otro trabajo sigue en marcha; la comparación puede tardar más.",tE="Doctor: busca fallos del registro. Calibrar: halla en él los parámetros del robot; antes empuje y conduzca el robot medio minuto, después calcula de diez segundos a dos minutos. Comparar: una página con números y figuras de todos los cuerpos.",nE="Registro",iE="Los archivos contienen el ensayo desde el último cambio, como mucho el último minuto.",sE="Datos, para una hoja de cálculo o para upright",oE="Páginas: números y figuras, o el ensayo para verlo otra vez",rE="Archivos, para las órdenes de upright",aE="Para mostrarlo: una imagen, o un enlace a esta configuración",lE="Registro CSV: lo que muestran las curvas, como máximo el último minuto, para una hoja de cálculo o para upright. Imagen: el robot como se ve ahora.",cE="El informe y la página de repetición requieren Python: los hace el laboratorio en vivo (upright lab).",hE="Registro CSV",uE="Registro Parquet",dE="Informe",fE="Página con la grabación",pE="Archivo del controlador",mE="Archivo del robot",gE="Imagen",_E="Copiar enlace",vE="Enlace copiado. Restaura toda esta configuración.",xE="No lleva ningún empujón.",bE="Repite el último empujón.",yE="Su empujón a mano va en él como un golpe del mismo impulso.",ME="Su empujón a mano fue demasiado largo para ir en él.",SE="{name} está listo",wE="Se recuperó de un empujón de {impulse} N s; el mayor hasta ahora {best} N s",EE="Se recuperó de un empujón de {impulse} N s, el mayor",TE="Se recuperó, pero no de un solo empujón: no es récord.",AE="Se cayó tras un empujón de {impulse} N s.",RE="Se cayó tras {impulse} N s de empujones.",CE="Se está leyendo {name}",PE="fuerza {force} N",LE="Clasificación",NE="Nombre",DE="Mayor empujón [N s]",IE="Esfuerzo",UE="Enviar mi configuración a todos",kE="Su nombre",FE="Escriba primero su nombre.",OE="Clave",BE="Entrar",zE="Unirse a la clase",HE="Paso {n} de {all}",VE="Haga",GE="Observe",WE="Piense",$E="Preparar",qE="Siguiente",XE="Volver a mi robot",jE=", sin la carga",YE=", en suelo horizontal",KE="Escribiendo el archivo",ZE="Anterior",JE=[["Mouse sobre el robot","arrastrar y mantener para empujar"],["Mouse sobre el suelo","arrastrar para cambiar la vista, rueda para acercarse"],["Un dedo","sobre el robot: empujarlo; al lado: cambiar la vista, de lado"],["← → ↑ ↓","girar y conducir; la palanca izquierda de un mando hace lo mismo"],["F, B","empujar por delante, por detrás, mientras se mantenga la tecla"],["K","golpe"],["Espacio","pausa y continuar"],[".","un paso"],[", y /","atrás y adelante en el tiempo, en pausa"],["S","poner de pie"],["1, 2, 3 …","abrir la primera, segunda, tercera … pestaña"],["N, P","paso siguiente y anterior del recorrido; Intro lo prepara"],["[ ] { } + −","cambiar la vista y acercarse, con el foco en la sala"],["?","esta lista"]],QE="Python",eT="Modelo lineal como fantasma junto al robot",tT="Carga que el controlador desconoce: {mass} g, a {height} cm sobre el eje",nT="El controlador queda como se diseñó, para un suelo horizontal y la electrónica tal como es.",iT="Copiar enlace",sT="Un enlace a este robot y este controlador, y al último empujón; uno breve a mano pasa a ser un golpe",oT="Enlace copiado. Quien lo abra verá este robot y este controlador.",rT="Esta página funciona por sí sola. Lo siguiente necesita upright en un computador con Python 3.11 o más nuevo. Instálelo una vez, en la carpeta descomprimida de upright:",aT="pip install .",lT="Copiar",cT="Copiado.",hT=[["Un registro del gemelo de este robot, que resiste un empujón","upright simulate -r {robot} -b twin -c {controller} -p hold:0.1,until=1 -o run.csv"],["Calibrar un robot a partir de su registro","upright calibrate run.csv --robot {robot}"],["Diseñar este controlador, con sus márgenes, y guardarlo","upright design {controller} -r {robot} -o controller.json"],["Certificar este controlador","upright certify {controller} -r {robot}"],["Su propio robot, de un archivo, en una página como esta","upright lab --export site --robot mine.toml"],["El laboratorio en vivo, con el gemelo MuJoCo, cargas, otra electrónica y todos los parámetros","upright lab"]],uT=[{title:"Empújelo",do:"Presione Dar un golpe. O arrastre el robot con el mouse o con un dedo, y suéltelo.",watch:"Las ruedas avanzan bajo el cuerpo, y su inclinación ψ vuelve a cero: 0,1 rad son 6°. θ es el ángulo de las ruedas. Antes del primer empujón puede quedar quieto: los motores no responden a voltajes pequeños. Una vez movido sigue oscilando un poco, por eso y por el ruido de los sensores.",ask:"¿Qué golpe aguanta como máximo? El deslizador Tamaño lo fija. El robot es el gemelo, que MuJoCo simula en lugar del robot real; los fantasmas pálidos son modelos más simples. ¿En qué se diferencian sus curvas en el segundo tras el golpe?",here:{watch:"Las ruedas avanzan bajo el cuerpo, y su inclinación ψ vuelve a cero: 0,1 rad son 6°. θ es el ángulo de las ruedas. Antes del primer empujón puede quedar quieto: los motores no responden a voltajes pequeños. Una vez movido sigue oscilando un poco, por eso y por el ruido de los sensores.",ask:"¿Qué golpe aguanta como máximo? El deslizador Tamaño lo fija. El fantasma pálido junto al robot es un modelo más simple, lineal: ¿en qué se diferencia su curva en el segundo tras el golpe?"}},{title:"Se cae solo",do:"Presione Preparar: entonces nada controla el robot. Empieza con una inclinación de 0,02 rad.",watch:"ψ crece como una exponencial, porque un polo en lazo abierto está en el semiplano derecho.",ask:"¿Cuánto tarda en duplicarse la inclinación? Compare con ln 2 entre el polo inestable (Ver, Ecuaciones)."},{title:"Linealizar",do:"Presione Preparar: solo arrancan los dos modelos, sin controlador, desde una inclinación pequeña.",watch:"Hágalo andar despacio. La inclinación ψ de ambos modelos coincide casi hasta el suelo. El ángulo de rueda θ se separa antes.",ask:"¿Qué términos aproxima el modelo lineal? Mire sen ψ y cos ψ. ¿Por qué θ lo muestra antes que ψ?"},{title:"Regular",do:"Presione Preparar: ahora un LQR lo equilibra. Inclínelo y cambie la inclinación aceptada en Controlador.",watch:"Una inclinación aceptada menor da una ganancia mayor: regreso más rápido, más tensión. Al inclinarlo se inclina más al principio, hasta que sus sensores lo muestran.",ask:"¿Cómo cambian los márgenes con una inclinación aceptada menor? ¿Qué cuesta un regreso rápido?",here:{do:"Presione Preparar: ahora un LQR lo equilibra. Inclínelo. Luego elija Ganancias a mano en Controlador y mueva un poco ψ inclinación → u.",watch:"La ganancia en ψ es negativa. Más lejos de 0 pide más tensión; mucho más lejos, o más cerca de 0, los márgenes se reducen y oscila largo rato. Al inclinarlo se inclina más al principio, hasta que sus sensores lo muestran.",ask:"¿Cómo cambian los márgenes con la ganancia en ψ? ¿Qué cuesta un regreso rápido?"}},{title:"Empujar por delante",do:"Presione Preparar: tras un segundo una fuerza por delante mantiene ψ en 0,1 rad y luego cesa.",watch:"El robot se inclina contra la fuerza. Al soltarlo rueda, se pasa y vuelve.",ask:"¿Por qué un empujón por delante mantiene una inclinación hacia delante? Piense en la suma de momentos."},{title:"Empujar por detrás",do:"Presione Preparar: tras un segundo una fuerza por detrás mantiene −0,12 rad y luego cesa.",watch:"La misma respuesta, reflejada y algo mayor. φ, en Más curvas, apenas se mueve.",ask:"¿Es la respuesta exactamente la imagen reflejada? ¿Qué haría diferentes los dos lados?"},{title:"Comparar",do:"Presione Preparar: el gemelo y los modelos se sostienen del mismo modo y se sueltan. Cuando estén de pie otra vez, abra Identificar y presione Comparar.",watch:"Las formas coinciden, los tiempos de establecimiento no: el modelo lineal se asienta de otro modo.",ask:"¿Cuál de las señales difiere más, y qué efecto físico hay detrás?"},{title:"Romper el modelo lineal",do:"Presione Preparar: el robot lleva una carga que ni el controlador ni el modelo lineal incluyen. Dele un golpe suave, luego uno más fuerte.",watch:"Tras un golpe suave el fantasma lineal vuelve al reposo, y el gemelo sigue oscilando mucho. Con 0,3 N s el fantasma, que no lleva carga, cae primero.",ask:"¿Qué carga permite el margen? Busque el límite.",here:{watch:"Tras un golpe suave el fantasma lineal vuelve al reposo, y el robot sigue oscilando mucho. Con 0,3 N s el fantasma, que no lleva carga, cae primero.",ask:"¿Se logra con ganancias a mano que lleve la carga? Pruébelo."}},{title:"Hacerlo robusto",do:"Presione Preparar: un diseño robusto tiene una ganancia para muchos robots. Repita sus empujones.",watch:"Conserva sus márgenes con robots distintos, pero no tiene que aguantar un golpe mayor. La luz del certificado muestra el riesgo.",ask:"¿Aguanta más que el regulador anterior? ¿Qué costó la robustez? Compare esfuerzo y recorrido en un informe."}],dT="Este robot no se puede simular. El anterior está de nuevo aquí.",fT="Fue demasiado a la vez: una parte se omitió. Espere un momento.",pT="La simulación se detuvo y comenzó de nuevo. Todos los robots están de pie.",mT="Su último cambio detuvo la simulación para todos. Aquí está el robot habitual en su lugar.",gT={handIn:cM,handInNote:hM,noReplay:uM,noRun:dM,decimal:fM,certify:pM,original:mM,results:gM,invite:_M,language:vM,title:xM,skip:bM,connecting:yM,starting:MM,connected:SM,lost:wM,replaying:EM,refused:TM,theme:AM,help:RM,close:CM,scene:PM,sceneNow:LM,fellNow:NM,twin:DM,nonlinear:IM,linear:UM,published:kM,calibrated:FM,twinNote:OM,nonlinearNote:BM,linearNote:zM,publishedNote:HM,calibratedNote:VM,hint:GM,moreCurves:WM,fewerCurves:$M,robotIs:qM,mark_impulse:XM,mark_front:jM,mark_back:YM,mark_pull_left:KM,mark_pull_right:ZM,mark_hand:JM,mark_held:QM,mark_stood:eS,best:tS,bestTip:nS,what:iS,newHere:sS,doing_certify:oS,doing_calibrate:rS,doing_doctor:aS,oneAtATime:lS,soFar:cS,stillTakes:hS,overdue:uS,lightNote:dS,fallen:fS,standUp:pS,tilt:mS,tiltTip:gS,pause:_S,play:vS,step:xS,stepTip:bS,speed:yS,back:MS,timeLine:SS,lies:wS,now:ES,pushes:TS,front:AS,frontTip:RS,backPush:CS,backTip:PS,impulse:LS,impulseTip:NS,pullLeft:DS,pullRight:IS,pullBoth:US,pullTip:kS,size:FS,sizeTip:OS,drive:BS,pitch:zS,pitch_rate:HS,wheel:VS,wheel_rate:GS,yaw:WS,yaw_rate:$S,charts:qS,window:XS,tabs:jS,tabController:YS,tabRobot:KS,tabKit:ZS,tabSee:JS,tabIdentify:QS,tabKeep:ew,tabTour:tw,tabClass:nw,family:iw,lqg:sw,lqr:ow,"lqr-complementary":"LQR con filtro complementario","lqr-state":"LQR con el estado verdadero (solo simulado)",lqi:rw,pid:aw,hinf:lw,mpc:cw,sliding:hw,robust:uw,gains:dw,off:fw,noLoop:pw,weights:mw,command:gw,ownWeights:_w,noWeights:vw,fixedWeights:xw,designing:bw,robustTakes:yw,gain:Mw,gainBoth:Sw,margins:ww,notWeakest:Ew,gainNote:Tw,gainMargin:Aw,phaseMargin:Rw,delayMargin:Cw,leastDelay:Pw,leastGain:Lw,leastGainLow:Nw,anyDelay:Dw,enoughRed:Iw,enoughAmber:Uw,thinMotors:kw,placesPending:Fw,placesCertificate:Ow,placesPython:Bw,saved:zw,lookHere:Hw,mark_tilt:Vw,noCertificateHere:Gw,enough:Ww,thin:$w,unlimited:qw,certificate:Xw,green:jw,amber:Yw,red:Kw,none:Zw,noCertificate:Jw,noneRed:Qw,noSuchRobot:e1,leftOut:t1,noSuchController:n1,certified:i1,fullCertificate:s1,preset:o1,openRobot:r1,numbers:a1,numbersNote:l1,ownNumbers:c1,payload:h1,payloadHeight:u1,slope:d1,grip:f1,bodies:p1,kit:m1,ideal:g1,noise:_1,delay:v1,voltage:x1,deadZone:b1,ownKit:y1,loop:M1,viewLabel:S1,bode:w1,nyquist:E1,poles:T1,portrait:A1,voltages:R1,voltagesNote:C1,torquesNote:P1,estimate:L1,estimateNote:N1,noEstimate:D1,equations:I1,equationsNote:U1,leftMotor:k1,rightMotor:F1,truth:O1,opinion:B1,saturated:z1,linearised:H1,openPoles:V1,source:G1,thisRun:W1,openLog:$1,doctor:q1,doctorTip:X1,calibrate:j1,calibrateTip:Y1,compare:K1,compareTip:Z1,stop:J1,comparing:Q1,compareWaits:eE,calibrateNote:tE,log:nE,keepNote:iE,keepData:sE,keepPages:oE,keepFiles:rE,keepShow:aE,csvNote:lE,keepLive:cE,csv:hE,parquet:uE,report:dE,replay:fE,controllerFile:pE,robotFile:mE,picture:gE,link:_E,linkCopied:vE,noPush:xE,namedPush:bE,knockPush:yE,heldPush:ME,made:SE,recovered:wE,recoveredMost:EE,recoveredSeveral:TE,lostPush:AE,lostPushes:RE,uploaded:CE,newtons:PE,board:LE,name:NE,bestPush:DE,effort:IE,broadcast:UE,yourName:kE,nameMissing:FE,token:OE,enter:BE,joinTitle:zE,tourStep:HE,tourDo:VE,tourWatch:GE,tourAsk:WE,tourSet:$E,next:qE,tourBack:XE,butPayload:jE,butSlope:YE,writing:KE,previous:ZE,keys:JE,tabPython:QE,ghost:eT,carries:tT,stays:nT,lookAtThis:iT,lookTip:sT,lookCopied:oT,pythonNote:rT,install:aT,copy:lT,copied:cT,python:hT,tour:uT,setBack:dT,tooMany:fT,restarted:pT,ended:mT},_T=JSON.parse(`[["there is no run to hand in; expected one of at most {0} s, with no change since Stand up; try: press Stand up, push the robot, then hand in","no hay un ensayo que entregar de {0} s como máximo y sin cambios desde Poner de pie; pruebe: pulse Poner de pie, empuje el robot y entregue"],["no robot is called '{0}'; expected one of {1}","no hay un robot '{0}'; hay {1}"],["no controller is called '{0}'; expected one of {1}","no hay un controlador '{0}'; hay {1}"],["{0} of {1} robots fell, {2} of them after a {3} at {4} battery: {5}","cayeron {0} de {1} robots, {2} de ellos tras {3} con batería {4}: {5}"],["{0} of {1} robots fell: {2}","cayeron {0} de {1} robots: {2}"],["the probability of a fall is below {0}","la probabilidad de caída es menor que {0}"],["the probability of a fall may be {0}, more than {1}","la probabilidad de caída puede ser de {0}, más de {1}"],["no linear margins are known","no se conocen márgenes lineales"],["stable with {0}","estable con {0}"],["stable up to {0}","estable hasta con {0}"],["the nominal loop is unstable, with a pole at |z| = {0}","el lazo nominal es inestable, con un polo en |z| = {0}"],["a signal {0} % stronger at {1} makes the loop unstable","una señal un {0} % mayor en {1} vuelve inestable el lazo"],["a signal {0} % weaker at {1} makes the loop unstable","una señal un {0} % menor en {1} vuelve inestable el lazo"],["motors {0} % stronger make the loop unstable","motores un {0} % más fuertes vuelven inestable el lazo"],["motors {0} % weaker make the loop unstable","motores un {0} % más débiles vuelven inestable el lazo"],["{0} ms more delay at {1} ({2} of a period) make the loop unstable","{0} ms más de retardo en {1} ({2} de un período) vuelven inestable el lazo"],["{0} ms more delay ({1} of a period) make the loop unstable","{0} ms más de retardo ({1} de un período) vuelven inestable el lazo"],["a motor is at its limit for {0} of the time after a {1} at {2} battery","un motor está en su límite el {0} del tiempo tras {1} con batería {2}"],["the robot rolls {0} m away after a {1} at {2} battery","el robot rueda {0} m tras {1} con batería {2}"],["at rest the robot sways by ±{0} rad after a {1} at {2} battery","en reposo el robot oscila ±{0} rad tras {1} con batería {2}"],["in a class, the certificate is computed on request","en una clase, el certificado se calcula cuando se pide"],["The loop is unstable: its largest pole is at |z| = {0}.","El lazo es inestable: su mayor polo está en |z| = {0}."],["{0}: unstable, so there is no margin.","{0}: inestable, así que no hay margen."],["{0}: survives {1}, and {2} or {3} of its gain.","{0}: soporta {1}, y una ganancia {2} o {3}."],["as weak as {0} %","de solo el {0} %"],["however weak","tan pequeña como se quiera"],["as strong as {0} %","de hasta el {0} %"],["however strong","tan grande como se quiera"],["{0} ms more delay at the {1}","{0} ms más de retardo en {1}"],["{0} ms more delay at {1}","{0} ms más de retardo en {1}"],["{0} ms more delay","{0} ms más de retardo"],["any delay at the {0}","cualquier retardo en {0}"],["any delay","cualquier retardo"],["a {0} has no known linear form","un controlador {0} no tiene forma lineal conocida"],["both motors","ambos motores"],["left motor","motor izquierdo"],["right motor","motor derecho"],["steering","giro"],["gyro","giróscopo"],["compass","brújula"],["left encoder","codificador izquierdo"],["right encoder","codificador derecho"],["encoder left","codificador izquierdo"],["encoder right","codificador derecho"],["both encoders","ambos codificadores"],["accelerometer","acelerómetro"],["the gyro","el giróscopo"],["the compass","la brújula"],["the left motor","el motor izquierdo"],["the right motor","el motor derecho"],["the left encoder","el codificador izquierdo"],["the right encoder","el codificador derecho"],["low","baja"],["full","plena"],["hold in front","sostener por delante"],["hold behind","sostener por detrás"],["front","por delante"],["back","por detrás"],["knock of {0} N s","golpe de {0} N s"],["hold at {0} rad","sostener a {0} rad"],["front hold","sostener por delante"],["back hold","sostener por detrás"],["push","empuje"],["battery","batería"],["fell","cayeron"],["saturated","saturado"],["travel [m]","recorrido [m]"],["peak [rad]","máximo [rad]"],["{0} on {1}: green","{0} en {1}: verde"],["{0} on {1}: amber","{0} en {1}: ámbar"],["{0} on {1}: red","{0} en {1}: rojo"],["certify: stopped","certificado: parado"],["doctor: stopped","doctor: parado"],["calibrate: stopped","calibración: parada"],["design: stopped","diseño: parado"],["{0}: read","{0}: leído"],["nothing was recorded yet; try: let it run for a moment","todavía no se grabó nada; pruebe: déjelo andar un momento"],["there is no file '{0}' here; try: upload it again","no hay un archivo '{0}' aquí; pruebe: ábralo otra vez"],["this run","este ensayo"],["{0}: {1} rows, {2} s, every {3} ms","{0}: {1} filas, {2} s, cada {3} ms"],["Nothing found: this log can be used as it is.","No se encontró nada: este registro puede usarse como está."],["what","qué"],["channel","canal"],["evidence","prueba"],["repair","arreglo"],["error","error"],["warning","aviso"],["note","nota"],["{0} of {1} readings repeat the previous one while the channel moves ({2}; {3} expected by chance), the first near {4} s","{0} de {1} lecturas repiten la anterior mientras el canal se mueve ({2}; por azar se esperan {3}), la primera cerca de {4} s"],["{0} of the rows are at the {1}, {2}, up to {3} consecutive","{0} de las filas están en el límite ({2}), hasta {3} seguidas"],["leave these rows out when a model is fitted","dejar fuera estas filas al ajustar un modelo"],["leave it out when a model is fitted","dejarlo fuera al ajustar un modelo"],["leave these rows out when a linear model is fitted, or use one that knows the limit","dejar fuera estas filas al ajustar un modelo lineal, o usar uno que conozca el límite"],["mean {0} rad/s over {1} s: a drift of {2} rad; plausible: at most {3} rad/s","media {0} rad/s durante {1} s: una deriva de {2} rad; plausible: como máximo {3} rad/s"],["{0} counts per turn, both encoders: noise of a rate from two rows {1} rad/s, its motion {2} rad/s","{0} cuentas por vuelta, ambos codificadores: ruido de una velocidad de dos filas {1} rad/s, su movimiento {2} rad/s"],["it reads {0} from {1} to {2} s, while the other sensors move on","lee {0} de {1} a {2} s, mientras los demás sensores siguen moviéndose"],["check the sensor and its cable; leave these rows out","revisar el sensor y su cable; dejar fuera estas filas"],["{0} counts per turn: noise of a rate from two rows {1} rad/s, its motion {2} rad/s","{0} cuentas por vuelta: ruido de una velocidad de dos filas {1} rad/s, su movimiento {2} rad/s"],["the pitch amplitude is only {0} rad: resolution and friction are as large as the dynamics","la amplitud de la inclinación es solo de {0} rad: resolución y fricción son tan grandes como la dinámica"],["its difference from the gyro follows {0} (partial R² {1}); its error while accelerating reaches {2} rad","su diferencia con el giróscopo sigue a la aceleración (R² parcial {1}); su error al acelerar llega a {2} rad"],["delayed by {0} relative to the {1}, by the pendulum equation (R² {2})","retrasado {0} respecto a {1}, según la ecuación del péndulo (R² {2})"],["the wheels respond {0} ms and the gyro {1} ms after a command ({2})","las ruedas responden {0} ms y el giróscopo {1} ms después de un mando"],["the unpredictable part of the command, {0} on both sides, turns the wheels forward (t = {1})","la parte impredecible del mando gira las ruedas hacia delante (t = {1})"],["the unpredictable part of the command, {0} on both sides, turns the wheels backward (t = {1})","la parte impredecible del mando gira las ruedas hacia atrás (t = {1})"],["each motor drives the other wheel: an unpredictable left-turn command turns them right (t = {0})","cada motor mueve la otra rueda: un mando impredecible a la izquierda gira a la derecha (t = {0})"],["log at the controller's rate; one-step regression on this log is biased","registrar al ritmo del controlador; la regresión de un paso en este registro está sesgada"],["if the controller is faster, log at its rate; one-step regression on this log is biased","si el controlador es más rápido, registrar a su ritmo; la regresión de un paso en este registro está sesgada"],["if commands were held for {0} ms, the wheels would lead by {1} ms (motor equation, R² {2}): the commands changed between the rows","si los mandos se mantuvieran {0} ms, las ruedas se adelantarían {1} ms (ecuación del motor, R² {2}): los mandos cambiaron entre las filas"],["the unpredictable part of the command moves the wheels {0} (± {1}) of the distance expected if held for {2} ms: the commands changed between the rows, or friction absorbs the small ones","la parte impredecible del mando mueve las ruedas el {0} (± {1}) de lo esperado si se mantuviera {2} ms: los mandos cambiaron entre las filas, o la fricción absorbe los pequeños"],["from t = {0} s the pitch turns by {1} rad at up to {2} rad/s, {3}","desde t = {0} s la inclinación gira {1} rad a hasta {2} rad/s: una caída"],["from {0} to {1} s {2}: signs, units, delays and offsets are not judged there","de {0} a {1} s {2}: allí no se juzgan signos, unidades, retardos ni desviaciones"],["the robot lies","el robot yace"],["the robot lies after its fall","el robot yace tras su caída"],["the robot is upside down","el robot está cabeza abajo"],["the robot stands up","el robot se levanta"],["the robot is thrown, lifted or carried","el robot es lanzado, levantado o llevado"],["the robot balances nowhere in this log: no sign, unit, delay or offset can be judged","el robot no se equilibra en ningún momento de este registro: no se puede juzgar nada"],["the longest time on the wheels is from {0} to {1} s","el tiempo más largo sobre las ruedas es de {0} a {1} s"],["wheels at rest from {0} to {1} s (rows {2} to {3}): gyro noise {4} rad/s, no command; held by hand, or stuck by friction","ruedas en reposo de {0} a {1} s (filas {2} a {3}): ruido del giróscopo {4} rad/s, sin mando; sostenido con la mano, o parado por la fricción"],["wheels at rest from {0} to {1} s (rows {2} to {3}): gyro noise {4} rad/s, mean command {5}; held by hand, or stuck by friction","ruedas en reposo de {0} a {1} s (filas {2} a {3}): ruido del giróscopo {4} rad/s, mando medio {5}; sostenido con la mano, o parado por la fricción"],["wheel slip from {0} to {1} s: up to {2} rad/s² off the pendulum equation ({3} standard deviations), in both directions","deslizamiento de las ruedas de {0} a {1} s: hasta {2} rad/s² fuera de la ecuación del péndulo ({3} desviaciones típicas), en ambos sentidos"],["wheel slip at {0} s: up to {1} rad/s² off the pendulum equation ({2} standard deviations), in both directions","deslizamiento de las ruedas en {0} s: hasta {1} rad/s² fuera de la ecuación del péndulo ({2} desviaciones típicas), en ambos sentidos"],["a push at {0} s: up to {1} rad/s² off the pendulum equation ({2} standard deviations), in one direction","un empuje en {0} s: hasta {1} rad/s² fuera de la ecuación del péndulo ({2} desviaciones típicas), en un sentido"],["a push from {0} to {1} s: up to {2} rad/s² off the pendulum equation ({3} standard deviations), in one direction","un empuje de {0} a {1} s: hasta {2} rad/s² fuera de la ecuación del péndulo ({3} desviaciones típicas), en un sentido"],["remove them","quitarlas"],["keep the first row of each time","conservar la primera fila de cada instante"],["sort the rows, keep one for each time","ordenar las filas y conservar una de cada instante"],["interpolate them linearly","interpolarlas linealmente"],["resample at even times","remuestrear a intervalos iguales"],["use the parts as separate logs","usar las partes como registros separados"],["use the times of the log, as every command does, not row × period","usar los tiempos del registro, como hace cada orden, no fila × período"],["drop the channel","descartar el canal"],["check the cable and the mapped column","revisar el cable y la columna asignada"],["run it with a controller, or check the mapped column","ponerlo en marcha con un controlador, o revisar la columna asignada"],["record the robot while it stands, too","registrar el robot también mientras está de pie"],["subtract {0} rad/s","restar {0} rad/s"],["fit the angles, not their differences","ajustar los ángulos, no sus diferencias"],["take rates over several rows","calcular velocidades con varias filas"],["add a signal that makes it swing (upright excite), for a model","añadir una señal que lo haga oscilar (upright excite), para un modelo"],["fit gyro and encoders, not this estimate","ajustar giróscopo y codificadores, no esta estimación"],["multiply by −1","multiplicar por −1"],["multiply by {0}","multiplicar por {0}"],["divide by {0}","dividir entre {0}"],["shift it {0} earlier","adelantarlo {0}"],["include this dead time in the model, or shift the commands","incluir este tiempo muerto en el modelo, o desplazar los mandos"],["integrate both encoders","integrar ambos codificadores"],["differentiate it","derivarlo"],["swap left and right command","intercambiar mando izquierdo y derecho"],["exclude it from a fit","excluirlo de un ajuste"],["exclude these rows from a fit","excluir estas filas de un ajuste"],["exclude these rows from a fit, or log the push","excluir estas filas de un ajuste, o registrar el empuje"],["log a robot that balances","registrar un robot que se equilibra"],["use {0} s","usar {0} s"],["{0} of {1} readings are missing, the first at row {2}","faltan {0} de {1} lecturas, la primera en la fila {2}"],["all readings are missing","faltan todas las lecturas"],["it is {0} in all {1} rows","vale {0} en las {1} filas"],["{0} rows are missing at {1} places, the first after t = {2} s: steps of two or more periods of {3} ms","faltan {0} filas en {1} lugares, la primera tras t = {2} s: pasos de dos o más períodos de {3} ms"],["{0} from {1} samples","{0} a partir de {1} muestras"],["parameter","parámetro"],["value","valor"],["95 %","95 %"],["prior","a priori"],["unit","unidad"],["what the log tells","lo que dice el registro"],["visible","visible"],["prior dominates","domina el a priori"],["at its bound","en su límite"],["not fitted","no ajustado"],["refused","rechazado"],["wheel mass","masa de una rueda"],["wheel radius","radio de la rueda"],["wheel inertia","inercia de una rueda"],["body mass","masa del cuerpo"],["track","ancho de vía"],["com height","altura del centro de masa"],["pitch inertia","inercia de cabeceo"],["yaw inertia","inercia de guiñada"],["roll inertia","inercia de balanceo"],["rotor inertia","inercia del rotor"],["gear ratio","relación de transmisión"],["motor resistance","resistencia del motor"],["back emf","constante contraelectromotriz"],["torque constant","constante de par"],["motor friction","fricción del motor"],["wheel friction","fricción de la rueda"],["coulomb friction","fricción seca"],["rolling friction","resistencia a la rodadura"],["stiction rate","velocidad de suavizado"],["gravity","gravedad"],["body depth","fondo del cuerpo"],["body height","altura del cuerpo"],["asymmetry","asimetría de los motores"],["dead zone","zona muerta"],["constant command","mando constante"],["roll fraction","fracción de balanceo"],["motor gain","ganancia del motor"],["motor damping","amortiguamiento del motor"],["delay/gyro−encoder","retardo giróscopo−codificador"],["delay/{0}","retardo/{0}"],["command","mando"],["encoder","codificador"],["TWIPR (small BILBO): torque-controlled motors, centre of mass just above the axle.","TWIPR (BILBO pequeño): motores controlados en par, centro de masa apenas sobre el eje."],["The NXTway-GS design rebuilt with LEGO EV3 parts and motors, on small wheels of 21.5 mm radius; on large wheels: ev3way-large-wheels.","El diseño NXTway-GS con piezas y motores LEGO EV3, sobre ruedas pequeñas de 21,5 mm de radio; con ruedas grandes: ev3way-large-wheels."],["Yamamoto's NXTway-GS, the LEGO NXT robot whose published table Herrera et al. (2015) start from.","El NXTway-GS de Yamamoto, el robot LEGO NXT de cuya tabla publicada parten Herrera et al. (2015)."],["NXTway-GS with a rotor inertia of the size that is measured, 150 times the published estimate.","NXTway-GS con una inercia del rotor como la que se mide, 150 veces la estimación publicada."],["The EV3way design on wheels of about 45 mm radius: the LEGO EV3 robot of the published logs of sim2real-ev3way.","El diseño EV3way sobre ruedas de unos 45 mm de radio: el robot LEGO EV3 de los registros publicados de sim2real-ev3way."],["The robot behind the printed linear model of Herrera et al. (2015): twice as tall as NXTway-GS, on half the wheels.","El robot tras el modelo lineal impreso de Herrera et al. (2015): el doble de alto que NXTway-GS, sobre ruedas de la mitad."],["{0}; try: {1}","{0}; pruebe: {1}"],["the token is missing or wrong","la clave falta o no es correcta"],["open the address that your teacher shows","abra la dirección que muestra su docente"],["your name is missing","falta su nombre"],["write a name, so that the board can show it","escriba un nombre para que aparezca en la clasificación"],["every place is taken","todos los lugares están ocupados"],["close another page of the lab first","cierre antes otra página del laboratorio"],["too many messages","demasiados mensajes"],["wait a moment and reload the page","espere un momento y recargue la página"],["wait a minute and reload the page","espere un minuto y recargue la página"],["too many new robots from this address","demasiados robots nuevos desde esta dirección"],["upload it again","ábralo otra vez"],["kit '{0}' drives by {1}; expected {2}, as the robot","la electrónica '{0}' actúa por {1}; se esperaba {2}, como en el robot"],["voltage","tensión"],["torque","par"]]`),Mr={en:Er,es:gT};let wi=Er;function Rp(){return Object.keys(Mr).find(i=>Mr[i]===wi)??"en"}function Qu(i){wi=Mr[i]??Er,document.documentElement.lang=Rp(),document.title=wi.title}function bh(){return wi}function U(i,e={}){return wi[i].replace(/\{(\w+)\}/g,(t,n)=>vT(String(e[n]??"")))}function wn(i){const e=wi[i];return typeof e=="string"?e:i}function Wi(i){return wi.decimal==="."?i:i.replace(/(\d)\.(?=\d)/g,`$1${wi.decimal}`)}function ss(i,e){return Wi(i.toFixed(e).replace("-","−"))}function vT(i){return/^[−-]?\d+\.\d+$/.test(i)?Wi(i):i}const xT=i=>i.replace(/[.*+?^${}()|[\]\\]/g,"\\$&"),Cp=_T.map(([i,e])=>[new RegExp(`^${xT(i).replace(/\\\{\d\\\}(?= at )/g,"(.+)").replace(/\\\{\d\\\}/g,"(.+?)")}$`,"s"),e]);function Wt(i){if(wi===Er)return i;for(const[e,t]of Cp){const n=e.exec(i);if(n)return t.replace(/\{(\d)\}/g,(s,o)=>Wt(n[Number(o)+1]))}return Wi(i)}function Pp(i){return wi===Er||Cp.some(([e])=>e.test(i))}function Lp(i){return Pp(i)?Wt(i):U("original",{text:i})}function k(i,e={},...t){const n=document.createElement(i);for(const[s,o]of Object.entries(e))s.startsWith("on")?n.addEventListener(s.slice(2),o):s.includes("-")||s==="role"||s==="for"||s==="list"?n.setAttribute(s,String(o)):o!==void 0&&(n[s]=o);return n.append(...t.filter(s=>!!s)),n}function Qe(i,...e){xr(()=>i.replaceChildren(...e.filter(t=>!!t)))}function xr(i){const e=document.activeElement?.dataset?.key;i(),e&&document.activeElement===document.body&&document.querySelector(`[data-key="${e}"]`)?.focus({preventScroll:!0})}const Np=new WeakMap;function oi(i){const e=k("span",{className:"said"},i());return Np.set(e,i),e}function uc(i){for(const e of i.querySelectorAll(".said"))e.textContent=Np.get(e)?.()??""}function lt(i,e,t={}){return k("button",{type:"button",onclick:e,...t},i)}let ed=0;function Vs(i){return ed+=1,`${i}-${ed}`}function Dp(i,e){const t=k("input",{type:"text",inputMode:"decimal",autocomplete:"off",className:"number",...e,onchange:()=>{const n=t.value.trim().replace("−","-").replace(",","."),s=n!==""&&Number.isFinite(Number(n));t.setAttribute("aria-invalid",String(!s)),s&&i(Number(n))}});return{root:t,set:n=>{document.activeElement!==t&&(t.value=Wi(String(n)),t.removeAttribute("aria-invalid"))}}}function Kn(i,e,t){const n=Vs("slider"),s=m=>e.log?Math.log(m):m,o=m=>e.log?Math.exp(m):m,r=s(e.high)-s(e.low),a=k("input",{type:"range",id:n,min:String(s(e.low)),max:String(s(e.high)),step:String(e.step??r/200),"data-key":e.key??""}),l=m=>!e.log&&Math.abs(m)<1e-6*r?0:m,c=e.typed===void 0?null:Dp(m=>{a.value=String(s(m)),a.setAttribute("aria-valuetext",e.show(m)),t(m)},{"aria-label":i,"data-key":`${e.key??""}-typed`}),h=c?k("span",{className:"typed"},c.root,` ${e.typed}`):k("output",{for:n}),u=m=>{c?c.set(Number(m.toPrecision(4))):h.textContent=e.show(m),a.setAttribute("aria-valuetext",e.show(m))};a.addEventListener("input",()=>{const m=l(o(Number(a.value)));u(m),t(m)});const d=m=>{document.activeElement!==a&&(a.value=String(s(Math.max(m,e.log?e.low:-1/0)))),u(m)};return{root:k("div",{className:"slider"},k("label",{for:n},i),h,a),set:d}}function ds(i,e,t,n,s=""){const o=Vs("select"),r=k("select",{id:o,"data-key":s,onchange:()=>n(r.value)},...e.map(([a,l])=>k("option",{value:a,selected:a===t},l)));return k("div",{className:"choice"},k("label",{for:o},i),r)}function _t(i,e=3){return Number.isFinite(i)?Wi(Mh(String(Number(i.toPrecision(e))))):"∞"}function yh(i){return`${Wi(Mh(String(Number((i*180/Math.PI).toFixed(1)))))}°`}function Mh(i){const e=(t,n)=>` ×10${t==="-"?"⁻":""}${n.replace(/\d/g,s=>"⁰¹²³⁴⁵⁶⁷⁸⁹"[Number(s)])}`;return i.replace(/(?<=\d)e([+-]?)0*(\d+)\b/g,(t,n,s)=>e(n,s)).replace(/(?<=^|[\s(…])-(?=\.?\d)/g,"−")}function Ca(i,e,t=""){const n=i.length?k("thead",{},k("tr",{},...i.map(o=>k("th",{scope:"col"},o)))):null,s=k("tbody",{},...e.map(o=>k("tr",{},...o.map(r=>k("td",{},r)))));return k("div",{className:"table",tabIndex:0,"data-key":t&&`table-${t}`},k("table",{className:t},n,s))}function Sh(i,e){let t=0,n=null;return(...s)=>{n=s,!t&&(e(...s),n=null,t=window.setTimeout(function o(){if(t=0,n){const r=n;n=null,e(...r),t=window.setTimeout(o,i)}},i))}}const bT={twin:"#0072b2",nonlinear:"#d55e00",linear:"#00805c",calibrated:"#a0478a",published:"#6b6b00"},yT={twin:"#56b4e9",nonlinear:"#f2843c",linear:"#2fc79b",calibrated:"#dd93bd",published:"#c9c95a"},MT={nonlinear:[7,4],linear:[2,3],calibrated:[9,3,2,3],published:[12,5]};function ST(){return document.documentElement.dataset.theme==="dark"}function ls(i){return(ST()?yT:bT)[i]??"#888888"}function wh(i,e){return i===e[0]?[]:MT[i]??[]}function fs(){const i=getComputedStyle(document.documentElement),e=t=>i.getPropertyValue(t).trim();return{text:e("--ink"),soft:e("--soft"),grid:e("--grid"),push:e("--push")}}const td={front:[0,.5],back:[-.5,0],impulse:[-20,20],pull_left:[-100,100],pull_right:[-100,100],tilt:[-1.2,1.2]},wT=.5;class ET{push=null;kept="noPush";hand={from:0,at:0,force:0,impulse:0,on:!1};note(e,t){e.kind==="Strike"?this.name([e.what,e.size]):e.kind==="StandUp"&&e.pitch?this.name(["tilt",e.pitch]):e.kind==="Drag"&&this.drag(e.force,t)}name(e){[this.push,this.kept]=[e,e?"namedPush":"noPush"]}drag(e,t){const{hand:n}=this;if(!n.on&&!e)return;n.on||Object.assign(n,{from:t,at:t,force:0,impulse:0,on:!0}),n.impulse+=n.force*(t-n.at),[n.at,n.force,n.on]=[t,e,e!==0];const s=t-n.from<=wT;[this.push,this.kept]=s?[["impulse",Number(n.impulse.toPrecision(4))],"knockPush"]:[null,"heldPush"]}}function TT(i){const[e,t]=(new URLSearchParams(i.replace(/^#/,"")).get("push")??"").split(":"),[n,s]=Object.hasOwn(td,e)?td[e]:[0,-1];return Number(t)>=n&&Number(t)<=s?[e,Number(t)]:null}function AT([i,e]){return i==="tilt"?{kind:"StandUp",pitch:e}:{kind:"Strike",what:i,size:e}}const _a={slope:[-.35,.35],noise:[0,20],delay:[-1,.2],voltage:[-1,60],dead_zone:[-1,5],grip:[.02,10],seed:[0,2**31],payload:[0,5],payload_height:[0,1]},Eh=Object.keys(_a),Ip={gains:6,largest:7},nd=40,Up=i=>new URLSearchParams(i.replace(/^#/,"")),Gr=i=>i.length>nd?i.slice(0,nd)+"…":i,_l=i=>String(Number(i.toPrecision(6)));function Pa(i){const e=["robot","controller","kit","bodies","numbers","push",...Eh,...Object.keys(Ip)];return[...Up(i).keys()].some(t=>e.includes(t))}function RT(i,e,{usual:t,robots:n,keys:s}){const o=new URLSearchParams({robot:i.robot,controller:i.controller}),r=(l,c)=>s.includes(l)&&o.set(l,c);i.kit!==n[i.robot]?.kit&&r("kit",i.kit),i.controller==="gains"&&i.gains.length&&r("gains",i.gains.map(_l).join()),i.largest.length&&r("largest",i.largest.map(_l).join()),i.drive&&r("drive",i.drive),Object.keys(i.numbers).length&&r("numbers",Object.entries(i.numbers).map(([l,c])=>`${l}:${String(c)}`).join());for(const l of Eh)i[l]!==t[l]&&r(l,_l(i[l]));const a=i.bodies.filter(l=>l!=="calibrated");return a.length&&a.join()!==t.bodies.join()&&r("bodies",a.join()),e&&o.set("push",`${e[0]}:${Number(e[1].toPrecision(4))}`),"#"+o.toString().replaceAll("%2C",",").replaceAll("%3A",":")}function CT(i,e){const t=Up(i),[n,s]=[t.get("robot")??"",t.get("controller")??""],o=PT(t.get("numbers")??"",e.parameters),r=e.keys.includes("drive")&&t.has("drive")&&Object.keys(o).length===e.parameters.length,a=Object.hasOwn(e.robots,n),l={...e.usual,robot:a||n&&r?n:e.usual.robot},c=e.robots[l.robot]??e.robots[e.usual.robot];c.controllers.includes(s)&&(l.controller=s),l.kit=c.kit??l.kit;const h=(_,[p,f])=>_.trim()&&Number(_)>=p&&Number(_)<=f?Number(_):void 0,u=(_,p)=>[_.split(",").map(Number)].find(f=>f.length===p&&f.every(Number.isFinite)),d={...Object.fromEntries(Eh.map(_=>[_,p=>h(p,_a[_])])),...Object.fromEntries(Object.entries(Ip).map(([_,p])=>[_,f=>u(f,p)])),seed:_=>h(Number.isInteger(Number(_))?_:"",_a.seed),payload:_=>h(_,c.load===void 0?_a.payload:c.load?[c.load.payload,c.load.payload]:[0,0]),kit:_=>e.kits.find(p=>p===_),drive:_=>["voltage","torque"].find(p=>p===_),numbers:_=>Object.keys(o).length===_.split(",").length?o:void 0,bodies:_=>[e.bodies.filter(p=>_.split(",").includes(p))].find(p=>p.length===_.split(",").length)},m=[];for(const[_,p]of t){if(!Object.hasOwn(d,_))continue;const f=e.keys.includes(_)?d[_](p):void 0;f===void 0?m.push(Gr(`${_}=${p}`)):Object.assign(l,{[_]:f})}const g=TT(i);return t.has("push")&&!g&&m.push(Gr(`push=${t.get("push")??""}`)),{setup:l,push:g,left:m,robot:l.robot===n?"":Gr(n),controller:l.controller===s?"":Gr(s)}}function PT(i,e){const t=i.split(",").map(n=>n.split(":"));return Object.fromEntries(t.filter(([n,s])=>e.includes(n)&&s?.trim()&&Number.isFinite(Number(s))).map(([n,s])=>[n,Number(s)]))}function LT(i){return/[#&]token=([\w-]+)/.exec(i)?.[1]??""}const NT=7,Vi={robot:"nxtway-gs",numbers:{},drive:"",kit:"nxt",noise:1,delay:-1,voltage:-1,dead_zone:-1,grip:10,bodies:["twin","nonlinear","linear"],controller:"lqg",largest:[],gains:[],payload:0,payload_height:.15,slope:0,seed:0},Io=["pitch","pitch_rate","wheel","wheel_rate","yaw","yaw_rate"],Th=["rad","rad/s","rad","rad/s","rad","rad/s"],zs=["ψ","ψ̇","θ","θ̇","φ","φ̇"],Xa=.02,id=3200,DT=.15,sd=1e3,IT=.03,[UT,kT]=[.1,2],FT=["bodies","payload","payload_height","slope","grip","seed"];function Wr(i){return JSON.stringify(Object.entries(i).filter(([e])=>!FT.includes(e)))}function od({robot:i,drive:e,kit:t,controller:n}){return[i,e,t,n].join()}class Ah{t=[];x=[];estimate=[];volts=[[],[]];saturated=[];marks=[];breaks=[];other=!1;from=-1/0;begin(e){this.reset(this.x.length),this.from=e,this.other=!1}reset(e){this.from=-1/0,this.t=[],this.x=Array.from({length:e},()=>Io.map(()=>[])),this.estimate=[],this.volts=[[],[]],this.saturated=[],this.breaks=[],this.marks=[]}add(e){const t=this.t.at(-1);if(!(e.t<=this.from||t!==void 0&&e.t<t)){if(e.t===t){const n=this.t.length-1;if(e.x.length!==this.x.length||this.x.every((s,o)=>s.every((r,a)=>r[n]===e.x[o][a])))return;this.pop()}e.x.length!==this.x.length&&this.reset(e.x.length),this.push(e.t,e.x,e.e[0]??NaN,e.x[0][6],e.x[0][7],e.s),this.t.length>id+400&&this.cut(this.t.length-id)}}push(e,t,n,s,o,r){(this.other||this.jumps(e,t))&&this.breaks.push([this.t.at(-1)??e,e]),this.other=!1,this.t.push(e),t.forEach((a,l)=>this.x[l].forEach((c,h)=>c.push(a[h]))),this.estimate.push(n),this.volts[0].push(s),this.volts[1].push(o),this.saturated.push(r)}pop(){for(const e of[this.t,...this.x.flat(),this.estimate,...this.volts,this.saturated])e.pop();this.other=!0}jumps(e,t){const[n,s]=[this.t.length-1,e-(this.t.at(-1)??e)],o=(r,a,l)=>Math.abs(r[l]-a[l][n])>UT+kT*s*Math.max(Math.abs(r[l+1]),Math.abs(a[l+1][n]));return n>=0&&t.some((r,a)=>[0,2,4].some(l=>o(r,this.x[a],l)))}fill(e,t){if(!t.length)return;const n=Math.floor(t[0].length/6);(n!==this.x.length||(this.t.at(-1)??0)>e.at(-1)+1)&&this.reset(n);const s=new Ah;s.reset(n);let o=0;const r=a=>{for(;o<e.length&&e[o]<a-.001;o+=1){if(e[o]<=this.from||e[o]-(s.t.at(-1)??-1/0)<IT)continue;const[l,c]=[t[o],t[o].slice(6*n)];s.push(e[o],Array.from({length:n},(h,u)=>l.slice(6*u,6*u+6)),c[0],c[1],c[2],c[3])}};this.t.forEach((a,l)=>{r(a),s.push(a,this.x.map(c=>c.map(h=>h[l])),this.estimate[l],this.volts[0][l],this.volts[1][l],this.saturated[l])}),r(1/0),s.breaks.push(...this.breaks),s.marks.push(...this.marks),Object.assign(this,s,{from:this.from,other:this.other})}until(e){let t=this.t.length;for(;t>0&&this.t[t-1]>=e;)t-=1;for(const n of this.all())n.length=t;this.marks=this.marks.filter(n=>n.t<e)}cut(e){for(const t of this.all())t.splice(0,e);this.marks=this.marks.filter(t=>t.t>=this.t[0])}all(){return[this.t,this.estimate,...this.volts,this.saturated,...this.x.flat()]}}const kp={kind:"Light",light:"none",reasons:[],delay:null,delay_at:"",gain_low:null,low_at:"",gain_high:null,high_at:""};class OT{snapshot=null;traces=new Ah;changed=null;catalogue=null;analysed=null;equations=null;lit=null;board=null;found=null;certified=null;role="alone";session="";files="";invite="";setup=Vi;last=new ET;corrected=()=>{};say=()=>{};recorded=0;send=()=>{};listeners=[];sent=null;waiting=!1;fresh=!1;lain=null;asked=-sd;missing=1/0;get falls(){return this.setup.controller==="off"||this.analysed?.stable===!1}anew(e){this.fresh=!0,e(),this.fresh&&this.traces.begin(1/0)}acted(e){this.fresh?this.traces.begin(e):this.sent&&(this.sent.t=e),this.fresh=!1,this.sent=null}get settled(){return this.snapshot!==null&&!this.waiting&&this.changed?.busy===!1}note(e,t){const{hand:n}=this.last,{marks:s}=this.traces,o=n.on;this.last.note(e,t),e.kind==="Strike"?s.push({t,what:e.what,size:e.size}):e.kind==="StandUp"?s.push({t,what:e.pitch?"tilt":"stood",size:e.pitch}):n.on&&!o?s.push({t,what:"hand",size:0}):o&&s.at(-1)?.what==="hand"&&(s.at(-1).size=n.impulse),(e.kind==="Strike"||e.kind==="StandUp"||n.on&&!o)&&(this.sent=s.at(-1)??null)}listen(e){this.listeners.push(e)}change(e){this.expect(e),this.corrected(),this.send({kind:"Change",setup:this.setup})}push(e){(e.kind==="Strike"||e.force!==0)&&this.snapshot?.x[0][8]?this.hear({kind:"Notice",level:"info",text:"",key:"lies"}):this.send(e)}expect(e){const t=Wr(this.setup);this.setup={...this.setup,...e},Wr(this.setup)!==t&&(this.waiting=!0,this.forget())}forget(){this.analysed=null,this.certified=null,this.lit=kp;for(const e of this.listeners)e(this.lit)}recall(e){const t=this.traces.t.at(-1);t!==void 0&&e.t-t>=DT&&(this.missing=Math.min(this.missing,t)),!(this.missing===1/0||performance.now()-this.asked<sd)&&(this.asked=performance.now(),this.send({kind:"Recall",since:this.missing}),this.missing=1/0)}hear(e){switch(e.kind){case"Snapshot":this.snapshot=e,this.sent?.what==="hand"&&e.f[0]&&([this.sent.t,this.sent]=[e.t,null]),e.back||(this.lain=e.x.every(t=>t[8])?this.lain??e.t:null),e.back||(this.recall(e),this.traces.add(e));break;case"Welcome":this.traces.from=-1/0,this.role=e.role,this.session=e.session,this.files=e.files,this.invite=e.invite;break;case"Catalogue":this.catalogue=e;break;case"Changed":this.changedTo(e);break;case"Analysed":if(this.waiting)return;this.analysed=e;break;case"Equations":this.equations=e;break;case"Light":if(this.waiting)return;this.lit=e;break;case"Acted":this.acted(e.t);break;case"Board":this.board=e;break;case"JobResult":this.found=e,e.job==="certify"&&e.rows.length&&(this.certified=e);break;case"History":this.traces.fill(e.t,e.rows);break}for(const t of this.listeners)t(e)}changedTo(e){const t=this.changed?.bodies.join()===e.bodies.join(),n=this.changed,s=n!==null&&Wr(n.setup)!==Wr(e.setup);this.changed=e,this.traces.other||=n!==null&&(od(n.setup)!==od(e.setup)||n.busy&&!e.busy),s&&!this.waiting&&this.forget(),this.waiting=!1,this.setup=e.setup,t||this.traces.reset(e.bodies.length)}}const N=new OT,BT=13,zT=10.5,HT=5,VT=2;function GT({what:i,size:e}){const t=wn(e||i!=="hand"?`mark_${i}`:"mark_held"),n=/\{size\}.*/.exec(t);return[t,...n??[]].map(s=>s.replace("{size}",_t(Math.abs(e),2)))}class WT{root=k("div",{className:"marks"});shown="";draw(e,t){const{ctx:n,bbox:{left:s,top:o,width:r,height:a}}=e,l=t*devicePixelRatio,{push:c,soft:h}=fs();let u=s+r+16*l;const d=[],m=N.traces.marks.map(g=>({mark:g,x:e.valToPos(g.t,"x",!0)})).filter(({x:g})=>g>=s&&g<=s+r);n.save(),n.lineWidth=l,n.setLineDash([3*l,3*l]),n.font=`${zT*l}px system-ui, sans-serif`;for(const{mark:g,x:_}of m.reverse()){n.strokeStyle=g.what==="stood"?h:c,n.beginPath(),n.moveTo(_,o),n.lineTo(_,o+a),n.stroke();const p=VT*l,f=Math.min(...m.map(S=>S.x).filter(S=>S>_+p))-p,M=Math.max(s,...m.map(S=>S.x+p).filter(S=>S<_-p));for(const S of GT(g)){const x=n.measureText(S).width+3*l,F=Math.min(_,u-x,f-x);if(!(F<M||F+x<_)){d.push([S,g.what,F/devicePixelRatio]),u=F-HT*l;break}}}n.restore(),this.label(d)}label(e){const t=JSON.stringify(e.map(([n,s])=>[n,s]));t!==this.shown&&this.root.replaceChildren(...e.map(([n,s])=>k("span",{className:`event ${s}`},n))),this.shown=t,e.forEach(([,,n],s)=>this.root.children[s].style.left=`${n.toFixed(1)}px`)}}function Fp(i){try{const e=i();return e.getItem(""),e}catch{const e=new Map;return{getItem:t=>e.get(t)??null,setItem:(t,n)=>void e.set(t,n),removeItem:t=>void e.delete(t)}}}const os=Fp(()=>localStorage),ki=Fp(()=>sessionStorage);class dc{root;plot;marks=new WT;constructor(e,t,n,s,o){const r=fs(),a=parseFloat(getComputedStyle(document.documentElement).fontSize)/16,l={stroke:r.soft,grid:{stroke:r.grid,width:1},ticks:{show:!1},font:`${11*a}px system-ui, sans-serif`},c=k("div",{className:"plot","aria-hidden":"true"},this.marks.root);c.style.setProperty("--height",`${s/16}rem`),this.root=k("figure",{className:"strip",role:"group","aria-label":`${e} [${t}]`},k("figcaption",{},k("b",{},e),k("span",{},t)),c),this.plot=new _n({width:300,height:s,padding:[BT*a,18*a,0,0],cursor:{show:!1},legend:{show:!1},hooks:{draw:[h=>this.marks.draw(h,a)]},scales:{x:{time:!1},y:{range:(h,u,d)=>Op(u,d,o)}},axes:[{...l,size:20*a,values:(h,u)=>u.map(d=>d<0?"":Wi(`${+d.toFixed(2)} s`)),space:46*a},{...l,size:46*a,space:(h,u,d,m,g)=>Math.min(18*a,g/2.5),values:(h,u)=>u.map(d=>Wi(String(+d.toPrecision(4)).replace("-","−")))}],series:[{},...n.map(h=>({label:h.label,stroke:h.colour,width:(h.width??1.6)*a,dash:h.dash,points:{show:!1},spanGaps:!1,gaps:(u,d,m,g,_)=>[..._,...$T(u)].sort(([p],[f])=>p-f)}))]},[[],...n.map(()=>[])],c),new ResizeObserver(()=>this.fit(c)).observe(c)}fit(e){e.clientWidth>40&&this.plot.setSize({width:e.clientWidth,height:e.clientHeight})}show(e,t,n,s){this.plot.batch(()=>{this.plot.setData([e,...t],!1),this.plot.setScale("x",{min:n,max:s})})}}function $T(i){const{left:e,width:t}=i.bbox,n=2*devicePixelRatio;return N.traces.breaks.map(s=>s.map(o=>i.valToPos(o,"x",!0))).map(([s,o])=>[s-n/2,Math.max(o,s+n)]).filter(([s,o])=>s>e&&o<e+t)}function Op(i,e,t){if(!Number.isFinite(i)||!Number.isFinite(e))return[-t,t];const n=(i+e)/2,s=Math.max((e-i)/2*1.1,t);return[n-s,n+s]}const vl=[0,2],qT=[.05,.3,.5,1,.05,.2],Sr=matchMedia("(max-width: 40rem), (max-width: 62rem) and (max-height: 32rem)"),rd=matchMedia("(min-width: 40.01rem)");class XT{constructor(e){this.seconds=e;for(const t of[Sr,rd])t.addEventListener("change",()=>this.build())}root=k("section",{className:"charts"});strips=[];legend=k("div",{className:"legend"});slot=k("div",{className:"slot"});build(){this.root.setAttribute("aria-label",U("charts"));const e=N.changed?.bodies??[],t=e.map(c=>({label:wn(c),colour:ls(c),dash:wh(c,e)})),n=os.getItem("curves")==="all";this.strips=Io.map((c,h)=>n||vl.includes(h)?new dc(`${zs[h]}  ${wn(c)}`,Th[h],t,104,qT[h]):null),Qe(this.legend,...e.map(c=>Bp(c)));const s=Sr.matches?rd.matches?vl.slice(0,1):vl:[],o=this.strips.filter((c,h)=>s.includes(h)).map(c=>c?.root),r=this.strips.map(c=>c?.root).filter(c=>!o.includes(c)),a=lt(U(n?"fewerCurves":"moreCurves"),()=>{os.setItem("curves",n?"first":"all"),this.build(),this.root.querySelector("[data-key=curves]")?.focus()},{className:"quiet","aria-expanded":String(n),"data-key":"curves"}),l=c=>c.some(Boolean)?k("div",{className:`strips${n?" all":""}`},...c):null;Qe(this.slot,...o.length?[this.legend,l(o)]:[]),Qe(this.root,k("div",{className:"above"},o.length?null:this.legend,a),l(r))}draw(){const{t:e,x:t}=N.traces;if(!e.length||t.length!==N.changed?.bodies.length)return;const[n,s]=[this.seconds(),e.at(-1)],o=N.lain===null?s:Math.min(s,N.lain+.1*n),r=N.snapshot?.back?N.snapshot.t:Math.max(o,e[0]+n),a=r-n;let l=e.length;for(;l>0&&e[l-1]>=a;)l-=1;l=Math.max(0,l-1);const c=e.slice(l);this.strips.forEach((h,u)=>h?.show(c,t.map(d=>d[u].slice(l)),a,r))}}function Bp(i){const e=document.createElementNS("http://www.w3.org/2000/svg","svg");e.setAttribute("width","28"),e.setAttribute("height","10"),e.setAttribute("aria-hidden","true");const t=document.createElementNS("http://www.w3.org/2000/svg","line"),n={x1:"0",x2:"28",y1:"5",y2:"5",stroke:ls(i),"stroke-width":"2.5","stroke-dasharray":wh(i,N.changed?.bodies??[]).join(" ")};for(const[a,l]of Object.entries(n))t.setAttribute(a,l);e.append(t);const o={twin:U("twinNote"),nonlinear:U("nonlinearNote"),linear:U("linearNote"),published:U("publishedNote"),calibrated:U("calibratedNote")}[i]??"",r=i===N.changed?.bodies[0];return k("span",{className:"key",title:o},e,r?U("robotIs",{body:wn(i)}):wn(i))}const jT=60,YT=5e3;class KT{since=-1;lean=0;actions=[];begin(e,t,n){[this.since,this.lean]=[e,t],this.actions=n.speed||n.rate?[[0,{kind:"Steer",...n}]]:[]}stop(){this.since=-1}note(e,t){this.since>=0&&this.actions.length<YT&&this.actions.push([wo(t-this.since),e])}handIn(e,t,n,s,o){const r=wo(s-this.since);if(this.since<0||!(r>0&&r<=jT)||!e.trim())return null;const a={kind:"upright hand-in",version:1,student:e.trim(),setup:t,step:n,lean:this.lean,seconds:r,actions:this.actions,claimed:o};return La({...a,seal:QT(La(a))})}}function wo(i){return Number(i.toFixed(6))}const ZT=["version","seed"];function La(i,e=""){return typeof i=="number"?ZT.includes(e)?String(i):JT(i):Array.isArray(i)?`[${i.map(n=>La(n)).join(", ")}]`:i===null||typeof i!="object"?JSON.stringify(i):`{${Object.entries(i).sort(([n],[s])=>n<s?-1:1).map(([n,s])=>`${JSON.stringify(n)}: ${La(s,n)}`).join(", ")}}`}function JT(i){const[e,t]=i.toExponential().split("e").map((s,o)=>o?Number(s):s);if(i&&(t<-4||t>15))return`${e}e${t<0?"-":"+"}${String(Math.abs(t)).padStart(2,"0")}`;const n=Object.is(i,-0)?"-0":String(i);return n.includes(".")?n:`${n}.0`}function QT(i){const e=new TextEncoder().encode(i),t=Math.ceil((e.length+9)/64)*64,n=new Uint8Array(t);n.set(e),n[e.length]=128;const s=new DataView(n.buffer);s.setUint32(t-8,Math.floor(e.length/2**29)),s.setUint32(t-4,e.length<<3);const o=ad.slice(0,8).map(c=>ld(Math.sqrt(c))),r=ad.map(c=>ld(Math.cbrt(c))),a=new Int32Array(64),l=(c,h)=>c>>>h|c<<32-h;for(let c=0;c<t;c+=64){for(let M=0;M<16;M+=1)a[M]=s.getInt32(c+4*M);for(let M=16;M<64;M+=1){const[S,x]=[a[M-15],a[M-2]];a[M]=a[M-16]+(l(S,7)^l(S,18)^S>>>3)+a[M-7]+(l(x,17)^l(x,19)^x>>>10)}let[h,u,d,m,g,_,p,f]=o;for(let M=0;M<64;M+=1){const S=f+(l(g,6)^l(g,11)^l(g,25))+(g&_^~g&p)+r[M]+a[M]|0,x=(l(h,2)^l(h,13)^l(h,22))+(h&u^h&d^u&d)|0;[h,u,d,m,g,_,p,f]=[S+x|0,h,u,d,m+S|0,g,_,p]}[h,u,d,m,g,_,p,f].forEach((M,S)=>o[S]=o[S]+M|0)}return o.map(c=>(c>>>0).toString(16).padStart(8,"0")).join("")}const ad=Array.from({length:312},(i,e)=>e).filter(i=>i>1&&![2,3,5,7,11,13,17].some(e=>i%e===0&&i>e));function ld(i){return(i-Math.floor(i))*2**32|0}const cd=1e-9,eA=1-1e-9,[tA,nA]=[.3,.001],[iA,sA]=[3e3,160],va=(i,e)=>Array.from({length:i},()=>new Float64Array(e));function fc(i,e){const t=va(i.length,e[0].length);for(let n=0;n<i.length;n+=1){const[s,o]=[i[n],t[n]];for(let r=0;r<s.length;r+=1){const[a,l]=[s[r],e[r]];if(a)for(let c=0;c<o.length;c+=1)o[c]+=a*l[c]}}return t}const zp=i=>Math.max(...i.map(e=>e.reduce((t,n)=>t+Math.abs(n),0)));function hd({A:i,B:e},t){const n=[...i.map((a,l)=>Float64Array.from([...a,...e[l]],c=>c*t)),...va(2,8)],s=Math.max(0,Math.ceil(Math.log2(zp(n)+1e-300))+2);let[o,r]=[va(8,8),va(8,8)];for(let a=0;a<8;a+=1)r[a][a]=1;for(let a=1;a<20;a+=1)o=o.map((l,c)=>l.map((h,u)=>h+r[c][u])),r=fc(r,n).map(l=>l.map(c=>c/a/2**s));for(let a=0;a<s;a+=1)o=fc(o,o);return o.slice(0,6)}function xl(i,e){const t=Math.floor(i/e+cd),n=i-t*e;return[t,n>cd*e?n:0]}function ud(i,e,t,n=0,s=!1){const o=i.period,[r,a]=xl(i.dead+n,o),l=xl(i.dead,o)[0],c=S=>{const[x,F]=[hd(i,Math.min(S,a)),hd(i,Math.max(S-a,0))],P=(A,I,E)=>A.map(y=>y.reduce((R,V,O)=>R+V*(O<6?I[O]:E[O-6]),0));return(A,I,E)=>P(F,P(x,A,E),I)},h=i.delays.map(S=>{const[x,F]=xl(S,o);return F?{count:x+1,enters:c(o-F)}:{count:x,enters:null}}),u=c(o),[d,m]=[r+(a?1:0),new Float64Array(6)],g=6+h.reduce((S,x)=>S+x.count,0),_=g+2*d,p=_+e.start.length+2*l,f=S=>{const x=new Float64Array(p),F=(X,Y)=>i.C[Y].reduce((te,le,he)=>te+le*X[he],0);let P=6;const A=Float64Array.from(h,({count:X},Y)=>(P+=X,X?S[P-1]:F(S,Y))),[I,E]=[S.slice(_,_+e.start.length),new Float64Array(8)];e.command(I,A,m,E,t);const y=s?(E[0]+E[1])/2:0,R=[E[0]-y,E[1]-y],V=X=>X?[...S.slice(g+2*X-2,g+2*X)]:R,[O,$]=[V(r),a?V(r+1):[0,0]];x.set(u(S,O,$)),P=6,h.forEach(({count:X,enters:Y},te)=>{X&&(x.set(S.subarray(P,P+X-1),P+1),x[P]=F(Y?Y(S,O,$):S,te)),P+=X}),d&&x.set([...R,...S.subarray(g,_-2)],g);const q=_+e.start.length;return e.update(I,A,m,E,t,l?S.slice(p-2):E.slice(0,2)),x.set(I,_),l&&x.set([...E.subarray(0,2),...S.subarray(q,p-2)],q),x},M=Array.from({length:p},(S,x)=>f(new Float64Array(p).fill(1,x,x+1)));return Array.from({length:p},(S,x)=>Float64Array.from(M,F=>F[x]))}function dd(i){let[e,t]=[i,0];for(let n=0;n<34;n+=1){const s=zp(e);if(t+=Math.log(s),!(s>0)||t<-1)return!0;if(t>60)return!1;e=e.map(o=>o.map(r=>r/s)),e=fc(e,e),t*=2}return!1}function fd(i){const e=i.length,t=i.map(a=>Float64Array.from(a));for(let a=1;a<e-1;a+=1){let l=a;for(let c=a+1;c<e;c+=1)Math.abs(t[c][a-1])>Math.abs(t[l][a-1])&&(l=c);if(t[l][a-1]){[t[a],t[l]]=[t[l],t[a]];for(const c of t)[c[a],c[l]]=[c[l],c[a]];for(let c=a+1;c<e;c+=1){const h=t[c][a-1]/t[a][a-1];if(h){for(let u=0;u<e;u+=1)t[c][u]-=h*t[a][u];for(const u of t)u[a]+=h*u[c]}}}}const n=i.map(()=>new Float64Array(e)),s=[];let[o,r]=[e-1,0];for(;o>=0;){let a=o;const l=u=>Math.hypot(t[u][u-1],n[u][u-1])<=Number.EPSILON*(Math.hypot(t[u][u],n[u][u])+Math.hypot(t[u-1][u-1],n[u-1][u-1]));for(;a>0&&!l(a);)a-=1;if(a===o){s.push([t[o][o],n[o][o]]),[o,r]=[o-1,0];continue}const[c,h]=r%11===10?[Math.abs(t[o][o-1])+t[o][o],n[o][o]]:oA(t,n,o);if(rA(t,n,a,o,c,h),r+=1,r>300)return s}return s}function oA(i,e,t){const n=(m,g)=>[i[m][g],e[m][g]],[s,o,r,a]=[n(t-1,t-1),n(t-1,t),n(t,t-1),n(t,t)],l=[(s[0]-a[0])/2,(s[1]-a[1])/2],c=lA(pd(bl(l,l),bl(o,r))),h=l[0]*c[0]+l[1]*c[1]<0?-1:1,u=pd(l,[h*c[0],h*c[1]]),d=u[0]||u[1]?aA(bl(o,r),u):u;return[a[0]-d[0],a[1]-d[1]]}function rA(i,e,t,n,s,o){for(let a=t;a<=n;a+=1)[i[a][a],e[a][a]]=[i[a][a]-s,e[a][a]-o];const r=[];for(let a=t;a<n;a+=1){const[l,c,h,u]=[i[a][a],e[a][a],i[a+1][a],e[a+1][a]],d=Math.hypot(l,c,h,u)||1,[m,g,_,p]=[l/d,c/d,h/d,u/d];r.push([m,g,_,p]);for(let f=a;f<=n;f+=1){const[M,S,x,F]=[i[a][f],e[a][f],i[a+1][f],e[a+1][f]];i[a][f]=m*M+g*S+_*x+p*F,e[a][f]=m*S-g*M+_*F-p*x,i[a+1][f]=m*x-g*F-_*M+p*S,e[a+1][f]=m*F+g*x-_*S-p*M}}r.forEach(([a,l,c,h],u)=>{const d=t+u;for(let m=t;m<=Math.min(d+1,n);m+=1){const[g,_,p,f]=[i[m][d],e[m][d],i[m][d+1],e[m][d+1]];i[m][d]=a*g-l*_+c*p-h*f,e[m][d]=a*_+l*g+c*f+h*p,i[m][d+1]=a*p+l*f-c*g-h*_,e[m][d+1]=a*f-l*p-c*_+h*g}});for(let a=t;a<=n;a+=1)[i[a][a],e[a][a]]=[i[a][a]+s,e[a][a]+o]}const pd=(i,e)=>[i[0]+e[0],i[1]+e[1]],bl=(i,e)=>[i[0]*e[0]-i[1]*e[1],i[0]*e[1]+i[1]*e[0]],aA=(i,e)=>[(i[0]*e[0]+i[1]*e[1])/(e[0]**2+e[1]**2),(i[1]*e[0]-i[0]*e[1])/(e[0]**2+e[1]**2)];function lA([i,e]){const t=Math.hypot(i,e);return[Math.sqrt(Math.max(t+i,0)/2),(e<0?-1:1)*Math.sqrt(Math.max(t-i,0)/2)]}function md(i,e,t){return e.slice(1).flatMap((n,s)=>{if(t[s]<0==t[s+1]<0)return[];let[o,r]=[e[s],e[s+1]];for(let a=0;a<60;a+=1){const l=(o+r)/2;i(l)<0==t[s]<0?o=l:r=l}return[(o+r)/2]})}const Hp=(i,e,t)=>Array.from({length:t},(n,s)=>i*(e/i)**(s/(t-1))),Vp=i=>Hp(.05,Math.PI/i,sA).filter((e,t)=>t%2===0);function cA(i,e){let[t,n]=[0,0];for(;i(n);){if(t>e)return 1/0;[t,n]=[n,n+nA]}for(let s=0;n&&s<12;s+=1){const o=(t+n)/2;i(o)?t=o:n=o}return t}const gd=i=>Number.isFinite(i)?i:null;function _d(i){if(!i.stable)return{...i,words:`The loop is unstable: its largest pole is at |z| = ${Math.hypot(...i.poles[0]).toFixed(4)}.`};const e=o=>`${Math.round(100*o)} %`,t=i.gain_low>0?`as weak as ${e(i.gain_low)}`:"however weak",n=(i.gain_high??1/0)<1e3?`as strong as ${e(i.gain_high??0)}`:"however strong",s=i.delay===null?"any delay":`${Math.round(1e3*i.delay)} ms more delay`;return{...i,words:`both motors: survives ${s}, and ${t} or ${n} of its gain.`}}function hA(i,e,t){const[n,s]=[!1,!0].map(A=>ud(i,e,t,0,A)),o=fd(n).sort((A,I)=>Math.hypot(...I)-Math.hypot(...A)),r=fd(s),a=A=>{const I=[Math.cos(A*i.period),Math.sin(A*i.period)];let[E,y]=[1,0];for(let R=0;R<o.length;R+=1){const[V,O,$,q]=[I[0]-o[R][0],I[1]-o[R][1],I[0]-r[R][0],I[1]-r[R][1]],[X,Y,te]=[$*$+q*q,V*$+O*q,O*$-V*q];[E,y]=[(E*Y-y*te)/X,(E*te+y*Y)/X]}return[E-1,y]},l=Math.PI/i.period,c=Vp(i.period),h=c.map(a),u={stable:Math.hypot(...o[0])<eA,poles:o,gain_low:1,gain_high:1,phase:0,delay:0,L:[c,h.map(([A])=>A),h.map(([,A])=>A)]};if(!u.stable)return _d(u);const d=Array.from({length:300},(A,I)=>(I+1)*l/300),m=[...Hp(Math.min(.001,l/1e6),l,iA),...d].sort((A,I)=>A-I),g=m.map(a),p=[0,l,...md(A=>a(A)[1],m,g.map(([,A])=>A))].map(A=>a(A)[0]).filter(A=>A<0&&A>-1e6).map(A=>-1/A).sort((A,I)=>A-I),f=A=>A.find(I=>!dd(s.map((E,y)=>E.map((R,V)=>R+(I+(I-1)/1e3)*(n[y][V]-R))))),M=([A,I])=>A*A+I*I-1,S=md(A=>M(a(A)),m,g.map(M)),x=S.map(A=>{const[I,E]=a(A);return(Math.atan2(E,I)+3*Math.PI)%(2*Math.PI)}),F=x.map((A,I)=>A/S[I]),P=cA(A=>dd(ud(i,e,t,A)),Math.min(tA,...F));return _d({...u,gain_low:f(p.filter(A=>A<1).reverse())??0,gain_high:f(p.filter(A=>A>1))??null,phase:gd(Math.min(...x.map(A=>Math.min(A,2*Math.PI-A)))),delay:gd(Math.min(P,...F))})}const[uA,dA,fA,pA]=[.05,.4,1,.5];class Rh{best=0;run=0;effort=0;given=0;impulse=0;lasted=0;calm=0;before=0;push(){this.given||([this.impulse,this.lasted,this.before]=[0,0,this.effort]),this.given+=1,this.calm=0}exchanged(){this.given+=this.given?1:0,this.impulse=0}anew(e){return Object.assign(new Rh,{best:this.best,given:e?1:0})}watch(e,t,n,s,o,r){if(this.effort+=(o[0]**2+o[1]**2)*e,t)this.impulse+=Math.abs(t)*e,this.lasted+=e,this.calm=0;else if(this.given&&(this.calm=Math.abs(n)<uA&&Math.abs(s)<dA?this.calm+e:0,r||this.calm>=fA))return this.ended(r);return null}ended(e){const t=this.given===1;return this.given=0,!this.impulse||this.lasted>pA&&!e?null:(t&&!e&&(this.run=Math.max(this.run,this.impulse)),this.best=Math.max(this.best,this.run),{kind:"Recovered",impulse:this.impulse,effort:this.effort-this.before,best:this.best,fell:e,single:t})}}function mA(i){const e=Math.round(i);return Math.abs(i%1)===.5&&e%2?e-1:e}const gA=(i,e,t,n,s,o,r,a)=>{const l=Math.abs(i),c=n<l?i:0,h=Math.abs(e),u=n<h?e:0,d=Math.abs(c),m=d<o?d:o,g=Math.abs(u),_=g<o?g:o,p=m+_,f=r*p,M=o-f,S=t<M?t:M,x=-S,F=S<c?S:c,P=c<x?x:F,A=-s,I=A<0?s:1,E=P/I,R=Math.trunc(E)*I,V=A<0?R:P,O=S<u?S:u,$=u<x?x:O,q=$/I,Y=Math.trunc(q)*I,te=A<0?Y:$,le=d<g?g:d,he=S<le?1:0;a[0]=V,a[1]=te,a[2]=M,a[3]=he},_A=(i,e,t,n,s,o,r,a)=>{const l=Math.abs(i),c=n<l?i:0,h=Math.abs(e),u=n<h?e:0,d=Math.abs(c),m=d<o?d:o,g=Math.abs(u),_=g<o?g:o,p=m+_,f=r*p,M=o-f,S=-t,x=t<c?t:c,F=c<S?S:x,P=-s,A=P<0?s:1,I=F/A,y=Math.trunc(I)*A,R=P<0?y:F,V=t<u?t:u,O=u<S?S:V,$=O/A,X=Math.trunc($)*A,Y=P<0?X:O,te=d<g?g:d,le=t<te?1:0;a[0]=R,a[1]=Y,a[2]=M,a[3]=le},vA=(i,e,t,n,s)=>{const o=i*t,r=e*n;s[0]=o,s[1]=r},xA=(i,e,t,n)=>{const s=e-t,o=e+t,r=o<i?o:i,a=i<s?s:r;n[0]=a},bA=(i,e,t,n,{quantum:s,noise:o,bias_walk:r,range:a,gain:l},c)=>{const h=r*n,u=e+h,m=l*i+u,g=o*t,_=m+g,p=-s,f=p<0?s:1,M=_/f,x=mA(M)*f,F=p<0?x:_,P=-a,A=a<F?a:F,I=F<P?P:A;c[0]=I,c[1]=u},yA=1.4,vd=1e-9;function MA(i,e,t,n){let s=0,o=0;for(const r of i){const a=r.start-vd<=e&&e<r.start+r.duration-vd;s+=a?r.force:0,o+=(a?r.force:0)*r.height}n[0]=s,n[1]=s?o/s:0,n[2]=t}function xd(i,e){const[t,n,s,o]=[i>>>16,i&65535,e>>>16,e&65535],r=t*o+Math.floor(n*o/65536),a=n*s+r%65536;return t*s+Math.floor(r/65536)+Math.floor(a/65536)}function Gp([i,e,t,n],[s,o]){for(let r=0;r<10;r+=1)[i,e,t,n]=[(xd(3449720151,t)^e^s)>>>0,Math.imul(3449720151,t)>>>0,(xd(3528531795,i)^n^o)>>>0,Math.imul(3528531795,i)>>>0],s=s+2654435769>>>0,o=o+3144134277>>>0;return[i,e,t,n]}function bd(i,e,t){const[n,s]=Gp([i,0,0,e],[t>>>0,0]),o=Math.sqrt(-2*Math.log((n+.5)/2**32)),r=Math.PI*(s/2**31-1);return[o*Math.cos(r),o*Math.sin(r)]}class SA{constructor(e,t,n,s){this.sensor=e,this.purpose=t,this.seed=n,this.count=0,this.held=0,this.touch=s,this.line=new Float64Array(e.delay+1).fill(s),this.bias=e.bias?e.bias*bd(0,t+64,n)[0]:0,this.out=new Float64Array(2)}read(e){const{play:t,delay:n,every:s}=this.sensor;return t&&(xA(this.touch,e,t,this.out),this.touch=e=this.out[0]),this.line[this.count%(n+1)]=e,this.count%s===0&&(this.held=this.fresh(this.line[(this.count+1)%(n+1)])),this.count+=1,this.held}fresh(e){const{bias_walk:t,noise:n}=this.sensor,[s,o]=t||n?bd(this.count,this.purpose,this.seed):[0,0];return bA(e,this.bias,s,o,this.sensor,this.out),this.bias=this.out[1],this.out[0]}}class wA{constructor(e,t,n,s){this.body=e,this.control=t,this.x=Float64Array.from(n),this.steps=0,this.z=Float64Array.from(t.law?.start??[]),this.before=Float64Array.from(this.z),this.y=new Float64Array(t.reads.length),this.u=new Float64Array(8),this.sent=new Float64Array(2),this.applied=new Float64Array(2),this.driven=new Float64Array(2),this.out=new Float64Array(4),this.w=new Float64Array(3),this.ideal=new Float64Array(6),this.twist=0,e.motion.read(this.x,this.applied,this.w,this.ideal),this.voltage=e.kit?.voltage??1/0,this.waiting=[],this.latest=[0,0],this.arrived=[0,0],this.seed=s,this.channels=(e.kit?.sensors??[]).map((o,r)=>new SA(o,r,s,this.raw(o.from))),this.values=new Float64Array(6+(e.kit?this.channels.length:6)),this.sense()}get t(){return this.steps*this.body.period}get fallen(){return Math.abs(this.x[0])>yA}raw(e){return e<0?this.voltage:this.ideal[e]}sense(){this.values.set(this.x),this.body.kit||this.values.set(this.ideal,6),this.channels.forEach((e,t)=>this.values[6+t]=e.read(this.raw(e.sensor.from)))}step(e,t){const{law:n,reads:s,stride:o,gains:r=[]}=this.control;this.before.set(this.z);for(let a=0;a<s.length;a+=1)this.y[a]=this.values[s[a]];n?.command(this.z,this.y,e,this.u,r),this.sent.set(this.u.subarray(0,2));for(let a=0;a<o;a+=1)t(this.t,this.w),this.move();n?.update(this.z,this.y,e,this.u,r,this.applied)}move(){const{motion:e,kit:t}=this.body;t?this.drive(t):this.applied.set(this.sent),vA(this.applied[0],this.applied[1],t?.left??1,t?.right??1,this.driven),this.driven[0]+=this.twist,this.driven[1]-=this.twist,e.step(this.x,this.driven,this.w,this.ideal),this.steps+=1,this.sense()}drive(e){const[t,n]=this.delayed(e),[s,o]=[e.limit??1/0,e.voltage??1/0];(e.volts?gA:_A)(t,n,s,e.dead_zone,e.quantum,o,e.sag,this.out),[this.applied[0],this.applied[1],this.voltage]=this.out}delayed(e){const[t,n]=this.sent;if(t!==this.latest[0]||n!==this.latest[1]){const s=e.jitter?Gp([this.steps,0,0,128],[this.seed>>>0,0])[0]%(e.jitter+1):0;this.waiting.push([this.steps+e.delay+s,t,n]),this.latest=[t,n]}for(;this.waiting.length&&this.waiting[0][0]<=this.steps;)this.arrived=this.waiting.splice(0,1)[0].slice(1);return this.arrived}}function EA(i){const e=new Float64Array(6);let t=0;const n=(s,o,r,a)=>{const l=i.turn*s[4],[c,h]=[Math.cos(s[0]),Math.sin(s[0])],u=i.radius*t+i.gravity*Math.sin(r[2])*Math.cos(s[4]),d=i.gravity*Math.cos(r[2]);a.set([s[2]-l-s[0],s[2]+l-s[0],s[1],s[4],u*c-d*h,u*h+d*c])};return{step(s,o,r,a){const l=[r[0],r[0]*r[1],r[2]];for(let c=0;c<6;c+=1){let h=0;for(let u=0;u<6;u+=1)h+=i.A[c][u]*s[u];e[c]=h+i.B[c][0]*o[0]+i.B[c][1]*o[1]+i.E[c][0]*l[0]+i.E[c][1]*l[1]+i.E[c][2]*l[2]}t=(e[3]-s[3])/i.period,s.set(e),n(s,o,r,a)},read:n}}const Jt=globalThis.uprightExport??null,Na=["nonlinear","linear"],xa="off",TA=200,AA=.02,yd=.3,RA=3,CA=1.5,PA=60,Md=.02,LA=2;function Wp({facts:i}){const e=Object.entries(i.robots).map(([n,{controllers:s,laden:o}])=>[n,{controllers:[...Object.keys(s),xa],load:o?.look??null}]),t=Vi.robot in i.robots?Vi.robot:i.catalogue.robots[0].name;return{usual:{...Vi,robot:t,bodies:[...Na]},robots:Object.fromEntries(e),kits:[],parameters:[],bodies:Na,keys:["gains","slope","noise","delay","seed","payload","payload_height","bodies"]}}class NA{loop;offset;constructor(e,t,n,s,o,r){this.offset=[0,0,o[2],0,o[4],0];const a=[o[0],o[1],0,o[3],0,o[5]];this.loop=new wA({motion:t,period:e.period,kit:n},s,a,r)}state(){const e=Array.from(this.loop.x,(t,n)=>t+this.offset[n]);return this.loop.fallen&&([e[0],e[1],e[3],e[5]]=[Math.sign(e[0])*CA,0,0,0]),e}row(){return[...this.state(),...this.loop.applied,this.loop.fallen?1:0]}shifted(e){return[e[2]+this.offset[2],e[4]+this.offset[4]]}estimate(e){const{before:t,y:n}=this.loop,[s,o]=[e.S??[],e.Sy??[]],r=(a,l)=>a.reduce((c,h,u)=>c+h*l[u],0);return s.map((a,l)=>r(a,t)+r(o[l],n)+this.offset[l])}}class DA{constructor(e){this.data=e,this.setup=Wp(e).usual,N.send=t=>this.take(t),N.hear(e.facts.welcome),N.hear(e.facts.catalogue),this.changeTo(this.setup),window.setInterval(()=>this.tick(),16)}setup;lanes=[];periods=0;owed=0;paused=!1;speed=1;back=0;n=0;wall=performance.now();target=new Float64Array(6);steer={speed:0,rate:0};hand={force:0,start:-1,duration:1/0,height:0};active=[];pulled={until:-1,force:0};acting=new Float64Array(3);pulling=0;kept=[];score=new Rh;recorder=new KT;run={rows:0,peak:0,travel:0,from:0};thinking=0;spent=0;get facts(){const e=this.data.facts.robots[this.setup.robot];return this.setup.payload&&e.laden?{...e,...e.laden}:e}get controller(){return this.facts.controllers[this.setup.controller]??null}get t(){return this.periods*this.facts.every}take(e){switch(N.note(e,this.t),e.kind){case"Change":this.changeTo(e.setup);break;case"Drag":e.force&&!this.hand.force&&this.score.push(),this.hand={...this.hand,force:e.force,height:e.height};break;case"Strike":this.strike(e.what,e.size);break;case"Steer":this.steer={speed:e.speed,rate:e.rate};break;case"Play":[this.paused,this.speed,this.back]=[e.paused,e.speed,e.paused?this.back:0];break;case"Step":this.stepped(e.periods);break;case"Scrub":[this.paused,this.back]=[!0,e.back];break;case"StandUp":this.stand(e.pitch);break;case"Save":e.what==="csv"?this.keepTraces():this.handIn(e.name);break;default:return}(e.kind==="Drag"||e.kind==="Strike"||e.kind==="Steer")&&this.recorder.note(e,this.t),this.show()}changeTo(e){const t=this.data.facts.robots,n=Object.hasOwn(t,e.robot)?e.robot:this.setup.robot,s=t[n].controllers,r=Object.hasOwn(s,e.controller)||e.controller===xa?e.controller:Object.keys(s)[0],a=e.gains.length===6?e.gains:s.gains?.gains??[],l=Na.filter((M,S)=>S===0||e.bodies.includes(M)),c=e.payload?t[n].laden?.look:void 0,{payload:h,payload_height:u}=c??Vi,[d,m]=[this.setup,this.lanes.length>0&&n===this.setup.robot];this.setup={...e,robot:n,controller:r,gains:a,bodies:l,payload:h,payload_height:u},this.recorder.stop();const g=m&&l.length===this.lanes.length,_=g&&r===d.controller&&e.noise===d.noise&&e.delay===d.delay&&h===d.payload,p=m&&!this.lanes[0].loop.fallen?this.lanes[0].state():[0,0,0,0,0,0],f=l.map((M,S)=>g&&!this.lanes[S].loop.fallen?this.lanes[S].state():p);if(JSON.stringify({...d,slope:0})!==JSON.stringify({...this.setup,slope:0})&&this.score.exchanged(),_)for(const M of this.lanes)M.loop.control.gains=a;else this.build(f);g||(this.kept=[]),m||this.traced(),this.said(!m||h!==d.payload)}said(e){const{facts:t,controller:n,setup:s}=this,o={delay:this.delay(),dead_zone:t.kit?.dead_zone??0,voltage:t.kit?.voltage??-1},r={kind:"Changed",setup:s,look:t.look,bodies:s.bodies,period:t.every,controller:n?.kind??xa,truth:n?.truth??!1,kit:o,busy:!1};if(N.hear(r),e&&N.hear(t.equations),N.analysed=null,window.clearTimeout(this.thinking),N.hear({...kp,...n?.least}),!n)return;const{plant:a}=n;n.analysed?N.hear({...n.analysed,L:[Vp(t.every),...n.analysed.L]}):a&&(this.thinking=window.setTimeout(()=>{const l=hA(a,this.data.laws[s.robot][s.controller],s.gains);N.hear({kind:"Analysed",gain:[s.gains],...l})},TA))}traced(){N.traces.reset(this.setup.bodies.length),this.kept=[],this.periods=0}delay(){return this.setup.delay<0?this.facts.delay_own:this.setup.delay}kit(){const{kit:e,period:t}=this.facts;if(!e)return null;const n=this.setup.noise,s=e.sensors.map(o=>({...o,quantum:o.quantum*n,noise:o.noise*n,bias:o.bias*n}));return{...e,sensors:s,delay:Math.round(this.delay()/t)}}build(e){const{facts:t,setup:n,controller:s}=this,o=s?this.data.laws[n.robot][n.controller]:null,r=s?.stride??Math.round(t.every/t.period),a={law:o,reads:s?.reads??[],stride:r,gains:n.gains},l=n.bodies.map(h=>h===Na[0]?this.data[n.payload?"laden":"motions"][n.robot]:EA(t.linear)),c=this.kit();this.lanes=l.map((h,u)=>new NA(t,h,c,{...a},e[u]??[0,0,0,0,0,0],n.seed)),this.target.fill(0),[this.owed,this.back]=[0,0],this.run={rows:0,peak:0,travel:0,from:this.lanes[0].loop.x[2]}}stand(e){[this.active,this.pulled]=[[],{until:-1,force:0}],this.hand={...this.hand,force:0},this.score=this.score.anew(e),this.build(this.lanes.map(()=>[e,0,0,0,0,0])),this.recorder.begin(this.t,e,this.steer),N.hear({kind:"Acted",t:this.t})}result(){const{rows:e,peak:t,travel:n}=this.run,{fallen:s}=this.lanes[0].loop;return{fell:s,seconds:wo((e-1)*this.facts.every),peak:wo(t),travel:wo(n*this.facts.look.wheel_radius),best:wo(this.score.run)}}handIn(e){const{facts:t}=this,n={...this.setup,...t.setup,gains:this.setup.controller==="gains"?this.setup.gains:[]},s=t.setup&&this.recorder.handIn(e,n,t.period,this.t,this.result());if(!s)return N.hear({kind:"Notice",level:"error",text:"",key:t.setup?"noRun":"noReplay"});const o=URL.createObjectURL(new Blob([s],{type:"application/json"}));N.hear({kind:"Made",what:"json",name:"hand-in.json",url:o})}keepTraces(){const{t:e,x:t,volts:n}=N.traces,s=this.facts.look.command_unit,o=Io.map((h,u)=>[`truth/${h}`,Th[u],t[0][u]]);o.push(["applied/left",s,n[0]],["applied/right",s,n[1]]);const r={robot:{name:this.setup.robot},controller:{kind:this.controller?.kind??xa},body:{kind:"nonlinear model, in a page",real:!1}},a=JSON.stringify({units:Object.fromEntries(o.map(([h,u])=>[h,u])),origin:r}),l=e.map((h,u)=>[h,...o.map(([,,d])=>d[u])].join()),c=[`# upright-log: ${a}`,["t",...o.map(([h])=>h)].join(),...l].join(`
`)+`
`;N.hear({kind:"Made",what:"csv",name:"run.csv",url:URL.createObjectURL(new Blob([c],{type:"text/csv"}))})}strike(e,t){const{look:n,equations:s,every:o}=this.facts,r=this.t;if(this.score.push(),N.hear({kind:"Acted",t:r}),e==="pull_left"||e==="pull_right")this.pulled={until:r+yd,force:e==="pull_left"?t:-t},this.active.push({force:t,start:r,duration:yd,height:0});else if(e==="impulse"){const a=Math.max(Math.round(AA/o),1)*o;this.active.push({force:t/a,start:r,duration:a,height:n.com_height})}else{const a=-s.weight*Math.sin(t)/(n.com_height*Math.cos(t)+n.wheel_radius);this.active.push({force:a,start:r,duration:RA,height:n.com_height})}}tick(){const e=performance.now(),t=Math.min((e-this.wall)/1e3,LA);this.wall=e,!this.paused&&(this.advance(t*this.speed),this.spent+=performance.now()-e,this.show())}advance(e){const{every:t}=this.facts;for(this.owed+=e;this.owed>=t*(1-1e-9);)this.owed-=t,this.period()}stepped(e){[this.paused,this.back]=[!0,0];for(let t=0;t<e;t+=1)this.period()}period(){const{every:e,look:t,pull:n}=this.facts,{t:s}=this;this.active=this.active.filter(g=>s<g.start+g.duration-1e-9);const o=this.hand.force?[...this.active,this.hand]:this.active,r=this.acting;MA(o,s,this.setup.slope,r);const a=s<this.pulled.until-1e-9?this.pulled.force:0;this.pulling=a;const l=this.steer.speed/t.wheel_radius;this.target.set([0,0,this.target[2]+l*e,l,this.target[4]+this.steer.rate*e,this.steer.rate]),this.noted();for(const{loop:g}of this.lanes)g.twist=a*n,g.fallen||g.step(this.target,(_,p)=>p.set(r));this.periods+=1;const{x:c,applied:h,fallen:u}=this.lanes[0].loop,d=this.score.watch(e,a?0:r[0],c[0],c[1],h,u);d&&N.hear(d);const m=this.kept.at(-1);(!m||this.t-m.t>=Md-1e-9)&&this.kept.push(this.snapshot()),this.kept.length>PA/Md+200&&this.kept.splice(0,200)}noted(){const{x:e,fallen:t}=this.lanes[0].loop;t||(this.run.rows+=1,this.run.peak=Math.max(this.run.peak,Math.abs(e[0])),this.run.travel=Math.max(this.run.travel,Math.abs(e[2]-this.run.from)))}snapshot(){const e=this.lanes[0],t=this.facts.look.limit??1/0,n=(e.loop.sent[0]**2>=t**2?1:0)+(e.loop.sent[1]**2>=t**2?2:0);return this.n+=1,{kind:"Snapshot",n:this.n,t:this.t,x:this.lanes.map(s=>s.row()),e:this.controller?e.estimate(this.controller):[],f:[...this.acting,this.pulling],r:e.shifted(this.target),s:n,paused:!1,back:0}}show(){const e=this.snapshot();if(this.back){const s=this.kept.findLast(o=>o.t<=e.t-this.back)??this.kept[0]??e;return this.n+=1,N.hear({...s,n:this.n,paused:!0,back:this.back})}const t=N.traces.t.at(-1)??-1/0,n=this.kept.findLastIndex(s=>s.t<=t);for(const s of this.kept.slice(n+1))s.t<e.t&&N.traces.add(s);N.hear({...e,paused:this.paused})}}const IA=1e3,UA=["nonlinear","linear"],kA=["twin","nonlinear","linear","published"];let Sd=0;function pc(){if(Jt)return Wp(Jt);const{robots:i,families:e,kits:t,units:n}=N.catalogue??{robots:[],families:[],kits:[],units:{}},s=e.map(r=>r.name),o=N.role==="alone"?Vi.bodies:UA;return{usual:{...Vi,bodies:o},robots:Object.fromEntries(i.map(({name:r,kit:a})=>[r,{kit:a,controllers:s}])),kits:t,bodies:kA,parameters:Object.keys(n),keys:Object.keys(Vi)}}function Ch(){return location.href.split("#")[0]+RT(N.setup,N.last.push,pc())}function FA(){if(!Pa(location.hash))return;const{setup:i,push:e,robot:t,controller:n,left:s}=CT(location.hash,pc()),{robots:o}=pc();N.change(i);const r=()=>[t&&U("noSuchRobot",{name:t,shown:i.robot,all:Object.keys(o).join(", ")}),n&&U("noSuchController",{name:n,shown:i.controller,all:o[i.robot].controllers.join(", ")}),s.length&&U("leftOut",{parts:s.join(", ")})].filter(Boolean).join(" ");r()&&N.say(r,"error"),N.last.name(e),window.clearTimeout(Sd);const a=()=>{Sd=N.settled?window.setTimeout(()=>(e||N.falls)&&N.send(AT(e??["tilt",Xa])),IA):window.setTimeout(a,100)};a()}const OA=Sh(60,i=>N.change(i));class BA{constructor(e){this.session=e}root=k("div",{className:"panel-body"});sliders=[];title=k("p",{className:"note"});ghost=null;load=null;build(){const e=(N.catalogue?.robots??[]).map(a=>[a.name,a.name]),t=ds(U("preset"),e,N.setup.robot,a=>N.change({robot:a,gains:[],delay:-1}),"robot"),n=(a,l,c,h,u,d)=>[a,Kn(l,{low:c,high:h,step:u,show:d,key:a},m=>OA({[a]:m}))];this.sliders=[n("slope",U("slope"),-.2,.2,.005,yh),n("noise",U("noise"),0,10,.1,a=>`× ${_t(a,2)}`),n("delay",U("delay"),0,.05,.001,a=>`${_t(a*1e3,2)} ms`)];const s=k("input",{type:"checkbox",id:"ghost","data-key":"ghost",onchange:()=>N.change({bodies:s.checked?["nonlinear","linear"]:["nonlinear"]})});this.ghost=s;const o=k("input",{type:"checkbox",id:"load","data-key":"load",onchange:()=>N.change({payload:o.checked?1:0})});this.load=o;const r=lt(U("ownKit"),()=>N.change({slope:0,noise:1,delay:-1,payload:0}),{className:"quiet","data-key":"own-kit"});Qe(this.root,k("div",{className:"column"},t,this.title,k("label",{for:"ghost",className:"check"},s,U("ghost")),this.carried),k("div",{className:"column wide"},k("div",{className:"sliders"},...this.sliders.map(([,a])=>a.root),k("p",{className:"note"},U("stays")),r))),this.update()}carried=k("label",{for:"load",className:"check"});update(){const e=this.root.querySelector("[data-key=robot]");e&&document.activeElement!==e&&(e.value=N.setup.robot),this.ghost&&(this.ghost.checked=N.setup.bodies.length>1);const t=this.session()?.facts,n=t?.laden?.look;Qe(this.carried,...n&&this.load?[this.load,U("carries",{mass:_t(n.payload*1e3,3),height:_t(n.payload_height*100,3)})]:[]),this.load&&(this.load.checked=N.setup.payload>0),this.title.textContent=t?`${Wt(t.title)} (${U("kit")}: ${t.kit_name})`:"";const s=this.sliders.find(([o])=>o==="delay")?.[1].root.querySelector("input");s&&(s.max=String(Math.max(.05,2*(t?.delay_own??0))));for(const[o,r]of this.sliders)r.set(o==="delay"?N.changed?.kit.delay??0:N.setup[o])}}function wd(i){const e=k("code",{tabIndex:0},i),t=lt(U("copy"),()=>{getSelection()?.selectAllChildren(e),navigator.clipboard?.writeText(i).then(()=>t.textContent=U("copied"),()=>{})},{"aria-label":`${U("copy")}: ${i}`,"data-key":`copy-${i.replace(/\W+/g,"-")}`});return k("div",{className:"shell"},e,t)}class zA{root=k("div",{className:"panel-body"});shown="";build(){const{robot:e,controller:t}=N.setup;this.shown=JSON.stringify([e,t]);const n={robot:e,controller:t},s=["off","gains"].includes(t),r=bh().python.map(([a,l])=>[a,s?l.replace(" -c {controller}",""):l]).filter(([,a])=>!(s&&a.includes("{controller}"))).flatMap(([a,l])=>[k("dt",{},a),k("dd",{},wd(l.replace(/\{(\w+)\}/g,(c,h)=>n[h]??"")))]);Qe(this.root,k("div",{className:"column full"},k("p",{className:"note"},U("pythonNote")),wd(U("install")),k("dl",{className:"commands"},...r)))}update(){this.shown!==JSON.stringify([N.setup.robot,N.setup.controller])&&this.build()}}function HA(i){return lt(U("lookAtThis"),()=>{const[e,{kept:t}]=[Ch(),N.last],n=()=>window.prompt(U("lookAtThis"),e),s=()=>`${U(location.protocol==="file:"?"lookHere":"lookCopied")} ${U(t)}`;navigator.clipboard?navigator.clipboard.writeText(e).then(()=>i(s),n):n()},{"data-key":"look",title:U("lookTip")})}class VA{constructor(e,t){this.credentials=e,this.say=t,N.send=n=>this.send(n),this.open()}socket=null;wait=250;closed=!1;first=!0;send(e){N.note(e,N.snapshot?.t??0),this.socket?.readyState===WebSocket.OPEN&&this.socket.send(JSON.stringify(e))}open(){this.say(this.first?"connecting":"lost");const e=new URL("ws",document.baseURI);e.protocol=e.protocol.replace("http","ws"),e.hash="";const t=new WebSocket(e);this.socket=t,t.onopen=()=>this.greet(),t.onmessage=n=>this.hear(JSON.parse(n.data)),t.onclose=()=>this.lost()}greet(){const e=this.first&&Pa(location.hash);this.send({kind:"Hello",version:NT,session:e?"":ki.getItem("session")??"",token:this.credentials.token,name:this.credentials.name,setup:N.changed?N.setup:null})}hear(e){e.kind==="Snapshot"&&this.send({kind:"Ack",n:e.n}),e.kind==="Welcome"&&(ki.setItem("session",e.session),this.wait=250,this.first=!1,this.say("connected")),e.kind==="Refused"&&(this.closed=!0,this.say("refused",e.reason)),N.hear(e)}lost(){this.closed||(this.say("lost"),window.setTimeout(()=>this.open(),this.wait),this.wait=Math.min(this.wait*1.6,3e3))}}const GA="http://www.w3.org/2000/svg",ir=420,qt={left:58,right:10,top:8,bottom:34};function br(i){const e=i.square?ir*.82:190,t=Xn("svg",{viewBox:`0 0 ${ir} ${e}`,role:"img","aria-label":i.title,class:"drawing"}),n=_=>i.logX?Math.log10(_):_,[s,o]=[n(i.x[0]),n(i.x[1])],[r,a]=[ir-qt.left-qt.right,e-qt.top-qt.bottom],l=_=>qt.left+(n(_)-s)/(o-s)*r,c=_=>qt.top+(1-(_-i.y[0])/(i.y[1]-i.y[0]))*a,h=fs(),u=`clip-${Math.random().toString(36).slice(2)}`,d=Xn("clipPath",{id:u});d.append(Xn("rect",{x:qt.left,y:qt.top,width:r,height:a})),t.append(d);for(const _ of i.logX?qA(i.x):Ed(i.x,6))t.append(Xn("line",{x1:l(_),x2:l(_),y1:qt.top,y2:qt.top+a,stroke:h.grid})),t.append($r(Td(_),l(_),qt.top+a+14,"middle",h.soft));for(const _ of Ed(i.y,5))t.append(Xn("line",{x1:qt.left,x2:ir-qt.right,y1:c(_),y2:c(_),stroke:h.grid})),t.append($r(Td(_),qt.left-6,c(_)+4,"end",h.soft));t.append($r(i.xLabel,qt.left+r/2,e-4,"middle",h.soft));const m=$r(i.yLabel,0,0,"middle",h.soft);m.setAttribute("transform",`translate(9 ${qt.top+a/2}) rotate(-90)`),t.append(m);const g=Xn("g",{"clip-path":`url(#${u})`});t.append(g),i.circle&&g.append(Xn("ellipse",{cx:l(0),cy:c(0),rx:l(1)-l(0),ry:c(0)-c(1),fill:"none",stroke:h.soft,"stroke-dasharray":"4 3"}));for(const _ of i.marks??[]){const p=_.y===void 0?{x1:l(_.x??0),x2:l(_.x??0),y1:qt.top,y2:qt.top+a}:{y1:c(_.y),y2:c(_.y),x1:qt.left,x2:ir-qt.right};g.append(Xn("line",{...p,stroke:h.push,"stroke-width":1.2,"stroke-dasharray":"5 3"}))}for(const _ of i.lines??[])g.append(WA(_,l,c));for(const _ of i.points??[])g.append($A(_.cross??!1,l(_.x),c(_.y),_.colour));return t}function Xn(i,e={}){const t=document.createElementNS(GA,i);for(const[n,s]of Object.entries(e))t.setAttribute(n,String(s));return t}function $r(i,e,t,n,s){const o=Xn("text",{x:e,y:t,"text-anchor":n,fill:s,"font-size":11.5});return o.textContent=i,o}function WA(i,e,t){let n="",s=!1;return i.x.forEach((o,r)=>{const a=i.y[r],l=Number.isFinite(o)&&Number.isFinite(a);l&&(n+=`${s?"L":"M"}${e(o).toFixed(1)} ${t(a).toFixed(1)}`),s=l}),Xn("path",{d:n,fill:"none",stroke:i.colour,"stroke-width":1.8,"stroke-dasharray":(i.dash??[]).join(" "),"stroke-linejoin":"round"})}function $A(i,e,t,n){if(!i)return Xn("circle",{cx:e,cy:t,r:4,fill:n});const s=4.5;return Xn("path",{d:`M${e-s} ${t-s}L${e+s} ${t+s}M${e-s} ${t+s}L${e+s} ${t-s}`,stroke:n,"stroke-width":1.8})}function Ed([i,e],t){const n=(e-i)/t,s=10**Math.floor(Math.log10(n)),o=[1,2,5,10].map(a=>a*s).find(a=>a>=n)??n,r=[];for(let a=Math.ceil(i/o)*o;a<=e+o*1e-6;a+=o)r.push(Math.abs(a)<o*1e-6?0:a);return r}function qA([i,e]){const t=[];for(let n=Math.ceil(Math.log10(i));10**n<=e;n+=1)t.push(10**n);return t}function Td(i){return Wi(String(+i.toPrecision(6)).replace("-","−"))}const[XA,jA]=[.04,.25];function $p(i){const e=N.lit,t=!!e?.delay_at,n=YA(t&&e?e:i);if(!t||!e)return[k("p",{className:`verdict ${n?"bad":"open"}`},n&&k("b",{},`${U("thinMotors")} `),n?"":U(Jt?"placesPython":e?.reasons.length?"placesCertificate":"placesPending"))];const s=e.light==="red"||e.light==="amber"?e.light:null,o=N.setup.payload>0?U("butPayload"):"",r=n?U("thin"):U(s==="red"?"enoughRed":s?"enoughAmber":"enough").replace(/\.$/,`${o}.`);return[k("p",{className:`verdict ${n?"bad":s?"open":"good"}`},k("b",{},r),` ${KA(e)} ${ZA(e)}`)]}function YA({delay:i,gain_low:e,gain_high:t}){return(i??1/0)<qp()||Math.min(1-(e??0),(t??1/0)-1)<XA}function qp(){return jA*(N.changed?.period??.01)}function KA({delay:i,delay_at:e}){return i===null?U("anyDelay"):U("leastDelay",{delay:_t(i*1e3,2),place:Wt(e),least:_t(qp()*1e3,2)})}function ZA({gain_low:i,low_at:e,gain_high:t,high_at:n}){const s=r=>_t(100*r,2),o={down:s(1-(i??0)),low:Wt(e)};return t===null?U("leastGainLow",o):U("leastGain",{...o,up:s(t-1),high:Wt(n)})}function JA(){const{delay_at:i,low_at:e,high_at:t}=N.lit??{delay_at:"",low_at:"",high_at:""},n=[i,e,t].some(s=>s&&s!=="both motors");return k("h4",{},U("margins"),n?` ${U("notWeakest")}`:"")}const QA=["loop","portrait","voltages","estimate","equations"],qr=8,eR=["ψ̇","ψ̈","θ̇","θ̈","φ̇","φ̈"];class tR{root=k("div",{className:"see"});view="loop";stage=k("div",{className:"stage"});strips=[];build(){const e=QA.map(n=>[n,U(n)]),t=ds(U("viewLabel"),e,this.view,n=>{this.view=n,this.show()},"view");Qe(this.root,t,this.stage),this.show()}show(){this.strips=[],this.view==="loop"?Qe(this.stage,...this.loop()):this.view==="equations"?Qe(this.stage,...oR()):this.view==="voltages"?this.voltages():this.view==="estimate"?this.estimate():this.portrait()}draw(){if(this.view==="portrait"&&this.portrait(),!this.strips.length)return;const e=N.traces,t=e.t.at(-1)??0;let n=e.t.length;for(;n>0&&e.t[n-1]>=t-qr;)n-=1;const s=e.t.slice(n),o=r=>r.slice(n);if(this.view==="estimate")this.strips[0].show(s,[o(e.x[0]?.[0]??[]),o(e.estimate)],t-qr,t);else{const r=[1,2].map((a,l)=>o(e.saturated).map((c,h)=>c&a?e.volts[l][n+h]:NaN));this.strips.forEach((a,l)=>a.show(s,[o(e.volts[l]),r[l]],t-qr,t))}}voltages(){const{text:e,push:t}=fs(),n=N.changed?.look.command_unit??"V";this.strips=[U("leftMotor"),U("rightMotor")].map(o=>new dc(o,n,[{label:o,colour:e,dash:[]},{label:U("saturated"),colour:t,dash:[],width:5}],150,1));const s=k("p",{className:"note"},U(n==="V"?"voltagesNote":"torquesNote"));Qe(this.stage,s,...this.strips.map(o=>o.root))}estimate(){if(!N.snapshot?.e.length){Qe(this.stage,k("p",{className:"note"},U("noEstimate")));return}const{push:e}=fs(),t=[{label:U("truth"),colour:ls(N.changed?.bodies[0]??"twin"),dash:[]},{label:U("opinion"),colour:e,dash:[4,3]}];this.strips=[new dc(`ψ: ${U("truth")} ──  ${U("opinion")} ╌╌`,"rad",t,190,.02)],Qe(this.stage,k("p",{className:"note"},U("estimateNote")),this.strips[0].root)}portrait(){const{t:e,x:t}=N.traces,n=(e.at(-1)??0)-qr;let s=e.length;for(;s>0&&e[s-1]>=n;)s-=1;const o=(r,a)=>{const l=t.map((d,m)=>{const g=N.changed?.bodies[m]??"";return{x:d[r].slice(s),y:d[r+1].slice(s),colour:ls(g),dash:wh(g,N.changed?.bodies??[])}}),c=(d,m)=>{const g=l.flatMap(f=>f[d]),[_,p]=[g.reduce((f,M)=>Math.min(f,M),1/0),g.reduce((f,M)=>Math.max(f,M),-1/0)];return Op(_,p,m)},h=l.map(d=>({x:d.x.at(-1)??0,y:d.y.at(-1)??0,colour:d.colour})),u=wn(Io[r]);return Da(u,br({title:`${U("portrait")}: ${u}`,xLabel:`${zs[r]} [rad]`,yLabel:`${zs[r+1]} [rad/s]`,lines:l,points:h,x:c("x",a[0]),y:c("y",a[1]),square:!0}))};Qe(this.stage,o(0,[.03,.4]),o(2,[.5,1]),o(4,[.05,.2]))}loop(){const e=N.analysed;if(N.setup.controller==="off")return[k("p",{className:"note"},U("noLoop"))];if(!e)return[k("p",{className:"note"},U("designing"))];const t=k("p",{className:"note"},ja(Wt(e.words))),n=ls("twin"),s=e.stable?$p(e):[t];return e.L.length===3&&s.push(...nR(e.L,n)),e.poles.length&&s.push(iR(e.poles,n)),s}}function nR([i,e,t],n){const s=i.map((u,d)=>20*Math.log10(Math.hypot(e[d],t[d]))),o=sR(i.map((u,d)=>Math.atan2(t[d],e[d])*180/Math.PI)),r=[i[0],i.at(-1)],a=(u,d)=>[Math.min(...u)-d,Math.max(...u)+d],l=[br({title:U("bode"),xLabel:"ω [rad/s]",yLabel:"|L| [dB]",lines:[{x:i,y:s,colour:n}],x:r,y:a(s,3),logX:!0,marks:[{y:0}]}),br({title:U("bode"),xLabel:"ω [rad/s]",yLabel:"∠L [°]",lines:[{x:i,y:o,colour:n}],x:r,y:a(o,8),logX:!0,marks:[{y:-180}]})],c=t.map(u=>-u),h=br({title:U("nyquist"),xLabel:"Re L",yLabel:"Im L",square:!0,x:[-3.2,1.6],y:[-2,2],circle:!0,lines:[{x:e,y:t,colour:n},{x:e,y:c,colour:n,dash:[4,3]}],points:[{x:-1,y:0,colour:fs().push,cross:!0}]});return[Da(U("bode"),...l),Da(U("nyquist"),h)]}function iR(i,e){const t=i.map(([o,r])=>({x:o,y:r,colour:Math.hypot(o,r)>=1?fs().push:e,cross:!0})),n=Math.max(1.15,...i.map(([o,r])=>Math.max(Math.abs(o),Math.abs(r))*1.1)),s=n*1.2;return Da(U("poles"),br({title:U("poles"),xLabel:"Re z",yLabel:"Im z",points:t,x:[-s,s],y:[-n,n],square:!0,circle:!0}))}function ja(i){return i.charAt(0).toUpperCase()+i.slice(1)}function Da(i,...e){return k("figure",{className:"titled","aria-label":i},k("figcaption",{},i),...e)}function sR(i){let e=0;return i.map((t,n)=>(n&&(e+=Math.round((i[n-1]-t)/360)*360),t+e)).map((t,n,s)=>t-Math.round((s[0]+180)/360)*360)}function oR(){const i=N.equations;if(!i)return[];const[e,,t,n]=i.inertias.map(p=>_t(p,4)),[s,o,r,a]=[i.alpha,i.beta,i.weight,i.lever].map(p=>_t(p,4)),[l,c]=[_t(i.swing,4),_t(i.half_track,4)],h=`(${a} cos ψ − ${_t(i.lever-i.inertias[1],3)})`,[u,d]=[`${s} (v_l + v_r)`,`2·${o} (θ̇ − ψ̇)`],m=[`${e} θ̈ + ${h} ψ̈ = ${u} − ${d} + ${a} (ψ̇² + φ̇²) sin ψ`,`${h} θ̈ + ${t} ψ̈ = −${u} + ${d} + (${r} + ${l} φ̇² cos ψ) sin ψ`,`(${n} + ${l} sin² ψ) φ̈ = ${c}·${s} (v_r − v_l) − 2·${c}²·${o} φ̇ − (2·${l} ψ̇ cos ψ + ${a} θ̇) φ̇ sin ψ`,`α = ${s}   β = ${o}   M g L = ${r} N m   M L R = ${a} kg m²   W/2R = ${c}`],g=(p,f)=>Ca([p,...f[0].map((M,S)=>p==="A"?zs[S]:["v_l","v_r"][S])],f.map((M,S)=>[eR[S],...M.map(x=>_t(x,4))]),"matrix"),_=i.poles.map(([p,f])=>_t(p,4)+(f?` ± ${_t(Math.abs(f),3)}j`:"")).join(";  ");return[k("div",{className:"equations"},...m.map(p=>k("div",{},p))),k("p",{className:"note"},U("equationsNote")),k("p",{},`${U("openPoles")}: ${_} 1/s`),k("h4",{},U("linearised")),g("A",i.A),g("B",i.B)]}function rR([i,,e,t,n]){const s=Wt(e.replace(/^\w+\//,"").replaceAll("_"," "));return k("li",{},k("b",{},[Wt(i),s].filter(Boolean).join(", ")),k("p",{},ja(Wt(t))),k("p",{className:"note"},n?`→ ${Wt(n)}`:""))}function Xp(i){const e=i.text.split(`
`).filter(Boolean),t=r=>r.replace(/\bin-(?=[\w.-]+\.\w+)/g,"").replace(/\b[a-z]+(_[a-z]+)+\b/g,a=>a.replaceAll("_"," ")),n=e.map(r=>k("li",{className:"note",lang:Pp(r)?"":"en"},t(Wt(r)))),s=r=>r.map(a=>Mh(Wt(i.job==="calibrate"?a.replaceAll("_"," "):a))),o=i.job==="doctor"?k("ul",{className:"findings"},...i.rows.map(rR)):Ca(i.header.map(Wt),i.rows.map(s),i.job);return[k("h4",{},t(Wt(i.title))),i.rows.length?o:null,n.length?k("ul",{className:"remarks"},...n):null]}const aR=1e3,lR=500;class jp{constructor(e){this.job=e;const t=e.startsWith("keep "),n=oi(()=>t?U("writing"):wn(e));n.id=Vs("job"),this.done.setAttribute("aria-labelledby",n.id);const s=oi(()=>t?"":wn(`doing_${e}`)),o={kind:"Cancel",job:e};this.root=k("div",{className:"bar"},k("b",{},n),k("button",{type:"button",onclick:()=>N.send(o),"data-key":`stop-${e}`},oi(()=>U("stop"))),this.done,this.words,k("p",{className:"note"},s));const r=window.setInterval(()=>this.share<1?this.say():window.clearInterval(r),lR);this.say()}root;done=k("progress",{max:1});words=k("span",{className:"note"});first={share:0,at:0};left=NaN;share=0;began=performance.now();at=this.began;to(e){const t=performance.now();e>0&&!this.first.share&&(this.first={share:e,at:t}),e>this.first.share&&t>this.first.at+aR&&(this.left=(1-e)*(t-this.first.at)/(e-this.first.share)),[this.share,this.at]=[e,t],this.done.value=e,this.say()}say(){const[e,t]=[performance.now(),o=>String(Math.ceil(o/1e3))],n=this.left-(e-this.at),s=Number.isNaN(n)?U("soFar",{seconds:t(e-this.began)}):n>0?U("stillTakes",{seconds:t(n)}):U("overdue",{seconds:t(e-this.began)});this.words.textContent=this.share?`${(100*this.share).toFixed(0)} % · ${s}`:U("oneAtATime")}}const cR=Sh(120,i=>N.change(i));let yl={};function xi(i){yl={...yl,...i},N.expect(i),cR(yl)}class Tr{root=k("div",{className:"panel-body"});update(){}}class hR extends Tr{weights=k("div",{className:"sliders"});numbers=k("div",{className:"numbers"});gain=k("div",{});light=k("div",{className:"light",role:"status"});sliders=[];shape="";bar=null;working=k("div",{});reported=null;certified=k("div",{className:"column full certified","aria-live":"polite"});build(){this.shape="",this.reported=null,Qe(this.certified);const e=(N.catalogue?.families??[]).map(s=>[s.name,wn(s.name)]),t=ds(U("family"),e,N.setup.controller,s=>{N.change({controller:s,gains:s==="gains"?this.present():N.setup.gains}),s==="off"&&N.send({kind:"StandUp",pitch:Xa})},"controller"),n=lt(U("fullCertificate"),()=>N.send({kind:"Start",job:"certify",file:""}),{"data-key":"certify"});Qe(this.root,k("div",{className:"column"},t,this.weights),k("div",{className:"column full"},this.gain),k("div",{className:Jt?"column full":"column"},this.numbers),Jt?k("p",{className:"note column full"},U("noCertificateHere")):k("div",{className:"column"},this.light,n,this.working),this.certified),this.update()}certify(){this.update(),this.certified.scrollIntoView({block:"nearest"})}certifying(e){if(this.root.querySelector("[data-key=certify]")?.toggleAttribute("aria-busy",e<1),e>=1&&!this.bar)return;const t=!this.bar;this.bar??=new jp("certify"),this.bar.to(e),Qe(this.working,e<1?this.bar.root:null),t&&this.working.scrollIntoView({block:"nearest"}),e>=1&&(this.bar=null)}present(){return N.analysed?.gain[0]?.slice(0,6)??[]}update(){const e=this.root.querySelector("[data-key=controller]");e&&document.activeElement!==e&&(e.value=N.setup.controller);const t=`${N.setup.controller} ${N.changed?.look.command_unit} ${N.setup.controller==="gains"?this.byHand().length:""}`;t!==this.shape&&this.shapeWeights(t),this.sliders.forEach((n,s)=>n.set(N.setup.controller==="gains"?this.byHand()[s]??0:this.sizes()[s])),Qe(this.gain,...this.gains()),Qe(this.numbers,...this.analysis()),Qe(this.light,...Zp()),this.reported!==N.certified&&(this.reported=N.certified,Qe(this.certified,...this.reported?[k("p",{},U("certified")),...Xp(this.reported)]:[]))}byHand(){return N.setup.gains.length?N.setup.gains:this.present()}sizes(){const e=N.changed?.look.command_unit??"V",t=[...N.catalogue?.largest??[],N.catalogue?.command[e]??1];return N.setup.largest.length===t.length?N.setup.largest:t}shapeWeights(e){this.shape=e;const t=N.catalogue?.families.find(n=>n.name===N.setup.controller);if(this.sliders=[],N.setup.controller==="gains"){const n=this.byHand(),s=Math.max(...n.map(Math.abs),.1),o=N.changed?.look.command_unit??"V",r=l=>`${o}${l%2?" s":""}/rad`,a=l=>Math.max(4*Math.abs(n[l]??0),s/4);this.sliders=zs.map((l,c)=>Kn(`${l} ${wn(Io[c])} → u`,{low:-a(c),high:a(c),step:a(c)/500,show:h=>`${_t(h,4)} ${r(c)}`,typed:r(c),key:`gain-${c}`},h=>{const u=[...this.byHand().length?this.byHand():[0,0,0,0,0,0]];u[c]=h,xi({gains:u})})),Qe(this.weights,...this.sliders.map(l=>l.root))}else if(t?.weights&&!Jt){const n=[...N.catalogue?.largest??[],N.catalogue?.command[N.changed?.look.command_unit??"V"]??1];this.sliders=n.map((o,r)=>this.weight(o,r));const s=lt(U("ownWeights"),()=>N.change({largest:[]}),{className:"quiet","data-key":"own-weights"});Qe(this.weights,k("p",{className:"note"},U("weights")),...this.sliders.map(o=>o.root),s)}else Qe(this.weights,N.setup.controller==="off"?null:k("p",{className:"note"},U(t?.weights?"fixedWeights":"noWeights")))}weight(e,t){const n=t<6?Th[t]:N.changed?.look.command_unit??"V",s=t<6?`${zs[t]} ${wn(Io[t])}`:U("command");return Kn(s,{low:e/10,high:e*10,log:!0,show:o=>`${_t(o,2)} ${n}`,key:`weight-${t}`},o=>{const r=[...this.sizes()];r[t]=o,xi({largest:r})})}gains(){const e=N.analysed?.gain??[];return!e.length||["gains","off"].includes(N.setup.controller)?[]:[k("h4",{},U("gain")),Ca(zs,[e[0].map(t=>_t(t,3))],"gains"),k("p",{className:"note"},U("gainNote",{unit:N.changed?.look.command_unit??"V"}))]}analysis(){const e=N.analysed;if(N.setup.controller==="off")return[k("p",{className:"note"},U("noLoop"))];if(!e)return[k("p",{className:"note"},U("designing")+(N.setup.controller==="robust"?" "+U("robustTakes"):""))];const t=[],n=(o,r)=>`${o===null?"0":_t(o,2)} … ${r===null?"∞":_t(r,3)}`,s=[[U("gainMargin"),n(e.gain_low,e.gain_high)],[U("phaseMargin"),e.phase===null?U("unlimited"):`${_t(e.phase*180/Math.PI,2)}°`],[U("delayMargin"),e.delay===null?U("unlimited"):`${_t(e.delay*1e3,3)} ms`]];return e.stable?t.push(...$p(e),JA(),Ca([],s,"margins")):t.push(k("p",{className:"note"},ja(Wt(e.words)))),t}}function Yp(){return N.setup.controller==="off"||(N.lit?.light??"none")==="none"?"":(N.setup.payload>0?U("butPayload"):"")+(N.setup.slope?U("butSlope"):"")}function Kp(){return N.setup.controller==="off"?"red":N.lit?.light??"none"}function Zp(){const i=N.setup.controller==="off",e=i?null:N.lit,t=Kp(),n=i?U("noneRed"):t==="none"&&e?.reasons.length?U("noCertificate"):U(t),s=k("span",{className:`lamp ${t}`,"aria-hidden":"true"});return[k("h4",{},U("certificate")),k("p",{className:"lit"},s,k("b",{},n+Yp())),t==="none"&&!e?.reasons.length?k("p",{className:"note"},U("lightNote")):null,...(e?.reasons??[]).map(o=>k("p",{className:"note"},ja(Wt(o))))]}class uR extends Tr{sliders=[];table=k("div",{className:"parameters"});fields=new Map;shown="";opened=!1;title=k("p",{className:"note"});build(){this.shown="",this.fields.clear();const e=(N.catalogue?.robots??[]).map(s=>[s.name,s.name]);e.some(([s])=>s===N.setup.robot)||e.push([N.setup.robot,N.setup.robot]);const t=ds(U("preset"),e,N.setup.robot,s=>this.choose(s),"robot");this.sliders=[["payload",Kn(U("payload"),{low:0,high:this.weight(),step:.005,show:s=>`${_t(s*1e3,3)} g`,key:"payload"},s=>xi({payload:s}))],["payload_height",Kn(U("payloadHeight"),{low:0,high:.5,step:.005,show:s=>`${_t(s*100,3)} cm`,key:"payload_height"},s=>xi({payload_height:s}))],["slope",Kn(U("slope"),{low:-.2,high:.2,step:.005,show:yh,key:"slope"},s=>xi({slope:s}))],["grip",Kn(U("grip"),{low:.02,high:10,log:!0,show:s=>_t(s,2),key:"grip"},s=>xi({grip:s}))]];const n=k("details",{open:this.opened,ontoggle:()=>this.opened=n.open},k("summary",{},U("numbers")),k("p",{className:"note"},U("numbersNote")),this.table);Qe(this.root,k("div",{className:"column"},t,this.title,Jp(U("openRobot"),".toml","robot")),k("div",{className:"column"},k("div",{className:"sliders"},...this.sliders.map(([,s])=>s.root))),k("div",{className:"column"},this.bodies()),k("div",{className:"column full"},n)),this.update()}weight(){return Math.max(.3,(N.changed?.look.weight??6)/9.81*.6)}choose(e){const t=N.catalogue?.robots.find(n=>n.name===e);t&&N.change({robot:e,numbers:{},drive:"",kit:t.kit,largest:[],gains:[],payload:0,delay:-1,voltage:-1,dead_zone:-1})}bodies(){const e=["twin","nonlinear","linear","published",...N.changed?.bodies.includes("calibrated")?["calibrated"]:[]],t=e.map(n=>{const s=Vs("body"),o=k("input",{type:"checkbox",id:s,checked:N.setup.bodies.includes(n),"data-key":`body-${n}`,onchange:()=>{const r=e.filter(a=>a===n?o.checked:N.setup.bodies.includes(a));r.length?N.change({bodies:r}):o.checked=!0}});return k("label",{for:s,className:"check"},o,Bp(n))});return k("fieldset",{},k("legend",{},U("bodies")),...t)}update(){for(const[n,s]of this.sliders)s.set(N.setup[n]);this.title.textContent=Wt(N.catalogue?.robots.find(n=>n.name===N.setup.robot)?.title??"");const e=JSON.stringify([N.setup.robot,N.setup.numbers,N.changed?.bodies]);if(e===this.shown)return;const t=this.shown!=="";this.shown=e,t&&!this.root.contains(document.activeElement)&&this.build(),this.parameters()}parameters(){const t={...N.catalogue?.robots.find(s=>s.name===N.setup.robot)?.numbers??{},...N.setup.numbers};if(Object.keys(t).join()===[...this.fields.keys()].join())return this.fields.forEach((s,o)=>s.set(t[o]));this.fields.clear();const n=Object.keys(t).map(s=>{const o=Vs("number"),r=Dp(l=>N.change({numbers:{...N.setup.numbers,[s]:l}}),{id:o,"data-key":`number-${s}`});this.fields.set(s,r);const a=N.catalogue?.symbols[s]??"";return k("div",{className:"parameter"},k("label",{for:o},`${Wt(s.replaceAll("_"," "))} ${a}`),r.root,k("span",{},(N.catalogue?.units[s]??"").replace(/^1$/,"")))});this.fields.forEach((s,o)=>s.set(t[o])),Qe(this.table,...n,lt(U("ownNumbers"),()=>N.change({numbers:{},drive:""}),{className:"quiet","data-key":"own-numbers"}))}}class dR extends Tr{sliders=[];build(){const e=(N.catalogue?.kits??[]).map(o=>[o,o==="ideal"?U("ideal"):o]),t=ds(U("kit"),e,N.setup.kit,o=>N.change({kit:o,delay:-1,voltage:-1,dead_zone:-1,noise:1}),"kit"),n=N.changed?.look.command_unit??"V";this.sliders=[["noise",Kn(U("noise"),{low:0,high:10,step:.1,show:o=>`× ${_t(o,2)}`,key:"noise"},o=>xi({noise:o}))],["delay",Kn(U("delay"),{low:0,high:.04,step:.002,show:o=>`${_t(o*1e3,2)} ms`,key:"delay"},o=>xi({delay:o}))],["voltage",Kn(U("voltage"),{low:1,high:14,step:.1,show:o=>o>0?`${_t(o,3)} V`:U("unlimited"),key:"voltage"},o=>xi({voltage:o}))],["dead_zone",Kn(U("deadZone"),{low:0,high:n==="V"?2:.1,show:o=>`${_t(o,2)} ${n}`,key:"dead_zone"},o=>xi({dead_zone:o}))]];const s=lt(U("ownKit"),()=>N.change({noise:1,delay:-1,voltage:-1,dead_zone:-1}),{className:"quiet","data-key":"own-kit"});Qe(this.root,k("div",{className:"column"},t,s),k("div",{className:"column wide"},k("div",{className:"sliders"},...this.sliders.map(([,o])=>o.root)))),this.update()}update(){const e=N.changed?.kit??{};for(const[n,s]of this.sliders)s.set(n==="noise"?N.setup.noise:e[n]);const t=this.root.querySelector("[data-key=kit]");t&&document.activeElement!==t&&(t.value=N.setup.kit)}}function Jp(i,e,t){const n=Vs("file"),s=k("input",{type:"file",id:n,accept:e,className:"file","data-key":`open-${t}`,onchange:()=>{const o=s.files?.[0];s.value="",o&&fR(o,t)}});return k("div",{className:"upload"},s,k("label",{for:n,className:"button"},i))}let Is="",Qp=()=>{};async function fR(i,e){const t=`upload/${N.session}?what=${e}&name=${encodeURIComponent(i.name)}`;N.say(()=>U("uploaded",{name:i.name}));try{const n=await fetch(t,{method:"POST",body:i}),{name:s,error:o}=await n.json();o?N.say(()=>Lp(o),"error"):e==="log"&&(Is=s??"",Qp())}catch{N.say(()=>U("lost"),"error")}}class pR extends Tr{bars=k("div",{className:"bars"});result=k("div",{className:"result",role:"region","aria-live":"polite"});shares=new Map;running=new Map;source="";constructor(){super(),Qp=()=>xr(()=>this.build())}build(){const e=[["",U("thisRun")]];Is&&e.push([Is,Is.replace(/^in-/,"")]),Is&&(this.source=Is);const t=ds(U("source"),e,this.source,r=>this.source=r,"source"),n=r=>N.send({kind:"Start",job:r,file:this.source}),s=k("div",{className:"row"},lt(U("doctor"),()=>n("doctor"),{title:U("doctorTip"),"data-key":"doctor"}),lt(U("calibrate"),()=>n("calibrate"),{title:U("calibrateTip"),"data-key":"calibrate"}),lt(U("compare"),()=>this.compare(),{title:U("compareTip"),"data-key":"compare"}));Qe(this.root,k("div",{className:"column"},t,Jp(U("openLog"),".csv,.txt,.log,.tsv,.dat,.json,.mat,.parquet,.mcap","log"),s,k("p",{className:"note"},U("calibrateNote")),this.bars),k("div",{className:"column wide"},this.result)),this.found()}compare(){N.send({kind:"Save",what:"report",name:this.source});const e=[...this.shares.keys()].some(t=>t!=="design")?"compareWaits":"comparing";N.say(()=>U(e))}progress(e,t){if(t>=1?this.shares.delete(e):this.shares.set(e,t),e==="design")return;const n=this.running.get(e)??new jp(e);n.to(t),t>=1?n.root.remove():this.running.has(e)||this.bars.append(n.root),t>=1?this.running.delete(e):this.running.set(e,n)}found(){const e=N.found;e&&Qe(this.result,...Xp(e))}}class mR extends Tr{constructor(e){super(),this.picture=e}files=new Map;saved=k("p",{className:"saved"});linked=k("div",{});links=k("div",{className:"links",role:"status"},this.linked,this.saved);buildExported(){uc(this.links);const e=lt(U("csv"),()=>N.send({kind:"Save",what:"csv",name:""}),{"data-key":"keep-csv"});Qe(this.root,k("div",{className:"column wide"},k("p",{className:"note"},U("csvNote")),k("div",{className:"row"},e,this.pictureButton()),k("p",{className:"note"},U("keepLive")),k("p",{className:"note"},U("handInNote")),this.handIn(),this.links))}build(){uc(this.links);const e=[[U("keepData"),[["csv",U("csv")],["parquet",U("parquet")]]],[U("keepPages"),[["report",U("report")],["replay",U("replay")]]],[U("keepFiles"),[["controller",U("controllerFile")],["robot",U("robotFile")]]]],t=([o,r])=>lt(r,()=>N.send({kind:"Save",what:o,name:""}),{"data-key":`keep-${o}`}),n=(o,...r)=>k("div",{},k("h4",{},o),k("div",{className:"row"},...r)),s=lt(U("link"),()=>void this.copy(),{"data-key":"link"});Qe(this.root,k("div",{className:"column wide"},k("p",{className:"note"},U("keepNote")),...e.map(([o,r])=>n(o,...r.map(t))),n(U("keepShow"),this.pictureButton(),s),k("p",{className:"note"},U("handInNote")),this.handIn(),this.links))}handIn(){const e=Vs("student"),t=k("input",{type:"text",id:e,maxLength:40,autocomplete:"name",value:ki.getItem("name")??"","data-key":"student"}),n=()=>{t.value.trim()?N.send({kind:"Save",what:"handin",name:t.value.trim()}):(t.focus(),N.say(()=>U("nameMissing")))};return k("div",{className:"row hand-in"},k("label",{for:e},U("yourName")),t,lt(U("handIn"),n,{"data-key":"keep-handin"}))}pictureButton(){return lt(U("picture"),()=>void this.photograph(),{"data-key":"picture"})}async photograph(){const e=await this.picture();e&&this.made(e.type.includes("svg")?"upright.svg":"upright.png",URL.createObjectURL(e))}async copy(){const[e,{kept:t}]=[Ch(),N.last];history.replaceState(null,"",e),await navigator.clipboard?.writeText(e).catch(()=>{});const n=k("input",{readOnly:!0,value:e,"aria-label":U("link"),className:"address"});Qe(this.linked,k("p",{className:"note"},oi(()=>`${U("linkCopied")} ${U(t)}`)),n),n.select()}made(e,t){const n=k("a",{href:t,download:e},e);this.files.set(e,n),Qe(this.saved,oi(()=>U("saved")),...[...this.files.values()].flatMap(s=>[" ",s])),n.click()}}class Ad{moments;at=0;paused=!1;speed=1;clock=performance.now();constructor(e){const t=e.filter(n=>n.kind==="Snapshot");this.moments=t.map(n=>({...n,t:n.t-t[0].t})),N.recorded=Math.max(this.length(),.02),N.send=n=>this.act(n);for(const n of e)n.kind!=="Snapshot"&&N.hear(n);window.setInterval(()=>this.tick(),20)}static inPage(){const e=document.getElementById("recording");return e?JSON.parse(e.textContent??"[]"):null}tick(){const e=performance.now();!this.paused&&this.moments.length&&(this.at+=(e-this.clock)/1e3*this.speed,this.at>this.length()&&this.rewind(),this.show()),this.clock=e}length(){return this.moments.at(-1)?.t??0}rewind(){this.at=0,N.traces.reset(this.moments[0].x.length)}show(){const e=this.at,t=N.traces.t.at(-1)??-1/0;e<t&&N.traces.until(e);const n=this.moments.filter(o=>o.t>t&&o.t<=e),s=n.at(-1)??this.moments.findLast(o=>o.t<=e);for(const o of n.slice(0,-1))N.traces.add(o);s&&N.hear({...s,paused:this.paused,back:0})}act(e){if(e.kind==="Play")this.paused=e.paused,this.speed=e.speed;else if(e.kind==="Scrub")this.at=Math.max(0,this.length()-e.back);else if(e.kind==="Step")this.paused=!0,this.at=Math.min(this.at+.02*e.periods,this.length());else if(e.kind==="StandUp")this.rewind();else return;this.show()}}/**
 * @license
 * Copyright 2010-2024 Three.js Authors
 * SPDX-License-Identifier: MIT
 */const Ph="170",gR=0,Rd=1,_R=2,em=1,tm=2,Ui=3,ps=0,Pn=1,Fi=2,cs=0,Ao=1,Cd=2,Pd=3,Ld=4,vR=5,Us=100,xR=101,bR=102,yR=103,MR=104,SR=200,wR=201,ER=202,TR=203,mc=204,gc=205,AR=206,RR=207,CR=208,PR=209,LR=210,NR=211,DR=212,IR=213,UR=214,_c=0,vc=1,xc=2,Uo=3,bc=4,yc=5,Mc=6,Sc=7,nm=0,kR=1,FR=2,hs=0,OR=1,BR=2,zR=3,HR=4,VR=5,GR=6,WR=7,im=300,ko=301,Fo=302,wc=303,Ec=304,Ya=306,Ia=1e3,Fs=1001,Tc=1002,ci=1003,$R=1004,Xr=1005,bi=1006,Ml=1007,Os=1008,$i=1009,sm=1010,om=1011,wr=1012,Lh=1013,Gs=1014,Oi=1015,Ar=1016,Nh=1017,Dh=1018,Oo=1020,rm=35902,am=1021,lm=1022,li=1023,cm=1024,hm=1025,Ro=1026,Bo=1027,um=1028,Ih=1029,dm=1030,Uh=1031,kh=1033,ba=33776,ya=33777,Ma=33778,Sa=33779,Ac=35840,Rc=35841,Cc=35842,Pc=35843,Lc=36196,Nc=37492,Dc=37496,Ic=37808,Uc=37809,kc=37810,Fc=37811,Oc=37812,Bc=37813,zc=37814,Hc=37815,Vc=37816,Gc=37817,Wc=37818,$c=37819,qc=37820,Xc=37821,wa=36492,jc=36494,Yc=36495,fm=36283,Kc=36284,Zc=36285,Jc=36286,qR=3200,XR=3201,pm=0,jR=1,as="",On="srgb",qo="srgb-linear",Ka="linear",Rt="srgb",ro=7680,Nd=519,YR=512,KR=513,ZR=514,mm=515,JR=516,QR=517,eC=518,tC=519,Dd=35044,Id="300 es",Bi=2e3,Ua=2001;class Xo{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});const n=this._listeners;n[e]===void 0&&(n[e]=[]),n[e].indexOf(t)===-1&&n[e].push(t)}hasEventListener(e,t){if(this._listeners===void 0)return!1;const n=this._listeners;return n[e]!==void 0&&n[e].indexOf(t)!==-1}removeEventListener(e,t){if(this._listeners===void 0)return;const s=this._listeners[e];if(s!==void 0){const o=s.indexOf(t);o!==-1&&s.splice(o,1)}}dispatchEvent(e){if(this._listeners===void 0)return;const n=this._listeners[e.type];if(n!==void 0){e.target=this;const s=n.slice(0);for(let o=0,r=s.length;o<r;o++)s[o].call(this,e);e.target=null}}}const mn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],Sl=Math.PI/180,Qc=180/Math.PI;function Rr(){const i=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(mn[i&255]+mn[i>>8&255]+mn[i>>16&255]+mn[i>>24&255]+"-"+mn[e&255]+mn[e>>8&255]+"-"+mn[e>>16&15|64]+mn[e>>24&255]+"-"+mn[t&63|128]+mn[t>>8&255]+"-"+mn[t>>16&255]+mn[t>>24&255]+mn[n&255]+mn[n>>8&255]+mn[n>>16&255]+mn[n>>24&255]).toLowerCase()}function Cn(i,e,t){return Math.max(e,Math.min(t,i))}function nC(i,e){return(i%e+e)%e}function wl(i,e,t){return(1-t)*i+t*e}function sr(i,e){switch(e.constructor){case Float32Array:return i;case Uint32Array:return i/4294967295;case Uint16Array:return i/65535;case Uint8Array:return i/255;case Int32Array:return Math.max(i/2147483647,-1);case Int16Array:return Math.max(i/32767,-1);case Int8Array:return Math.max(i/127,-1);default:throw new Error("Invalid component type.")}}function Rn(i,e){switch(e.constructor){case Float32Array:return i;case Uint32Array:return Math.round(i*4294967295);case Uint16Array:return Math.round(i*65535);case Uint8Array:return Math.round(i*255);case Int32Array:return Math.round(i*2147483647);case Int16Array:return Math.round(i*32767);case Int8Array:return Math.round(i*127);default:throw new Error("Invalid component type.")}}class vt{constructor(e=0,t=0){vt.prototype.isVector2=!0,this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){const t=this.x,n=this.y,s=e.elements;return this.x=s[0]*t+s[3]*n+s[6],this.y=s[1]*t+s[4]*n+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=Math.max(e.x,Math.min(t.x,this.x)),this.y=Math.max(e.y,Math.min(t.y,this.y)),this}clampScalar(e,t){return this.x=Math.max(e,Math.min(t,this.x)),this.y=Math.max(e,Math.min(t,this.y)),this}clampLength(e,t){const n=this.length();return this.divideScalar(n||1).multiplyScalar(Math.max(e,Math.min(t,n)))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){const t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;const n=this.dot(e)/t;return Math.acos(Cn(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){const t=this.x-e.x,n=this.y-e.y;return t*t+n*n}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){const n=Math.cos(t),s=Math.sin(t),o=this.x-e.x,r=this.y-e.y;return this.x=o*n-r*s+e.x,this.y=o*s+r*n+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}}class tt{constructor(e,t,n,s,o,r,a,l,c){tt.prototype.isMatrix3=!0,this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,n,s,o,r,a,l,c)}set(e,t,n,s,o,r,a,l,c){const h=this.elements;return h[0]=e,h[1]=s,h[2]=a,h[3]=t,h[4]=o,h[5]=l,h[6]=n,h[7]=r,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){const t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],this}extractBasis(e,t,n){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(e){const t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){const n=e.elements,s=t.elements,o=this.elements,r=n[0],a=n[3],l=n[6],c=n[1],h=n[4],u=n[7],d=n[2],m=n[5],g=n[8],_=s[0],p=s[3],f=s[6],M=s[1],S=s[4],x=s[7],F=s[2],P=s[5],A=s[8];return o[0]=r*_+a*M+l*F,o[3]=r*p+a*S+l*P,o[6]=r*f+a*x+l*A,o[1]=c*_+h*M+u*F,o[4]=c*p+h*S+u*P,o[7]=c*f+h*x+u*A,o[2]=d*_+m*M+g*F,o[5]=d*p+m*S+g*P,o[8]=d*f+m*x+g*A,this}multiplyScalar(e){const t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){const e=this.elements,t=e[0],n=e[1],s=e[2],o=e[3],r=e[4],a=e[5],l=e[6],c=e[7],h=e[8];return t*r*h-t*a*c-n*o*h+n*a*l+s*o*c-s*r*l}invert(){const e=this.elements,t=e[0],n=e[1],s=e[2],o=e[3],r=e[4],a=e[5],l=e[6],c=e[7],h=e[8],u=h*r-a*c,d=a*l-h*o,m=c*o-r*l,g=t*u+n*d+s*m;if(g===0)return this.set(0,0,0,0,0,0,0,0,0);const _=1/g;return e[0]=u*_,e[1]=(s*c-h*n)*_,e[2]=(a*n-s*r)*_,e[3]=d*_,e[4]=(h*t-s*l)*_,e[5]=(s*o-a*t)*_,e[6]=m*_,e[7]=(n*l-c*t)*_,e[8]=(r*t-n*o)*_,this}transpose(){let e;const t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){const t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,n,s,o,r,a){const l=Math.cos(o),c=Math.sin(o);return this.set(n*l,n*c,-n*(l*r+c*a)+r+e,-s*c,s*l,-s*(-c*r+l*a)+a+t,0,0,1),this}scale(e,t){return this.premultiply(El.makeScale(e,t)),this}rotate(e){return this.premultiply(El.makeRotation(-e)),this}translate(e,t){return this.premultiply(El.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){const t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,n,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){const t=this.elements,n=e.elements;for(let s=0;s<9;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<9;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){const n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e}clone(){return new this.constructor().fromArray(this.elements)}}const El=new tt;function gm(i){for(let e=i.length-1;e>=0;--e)if(i[e]>=65535)return!0;return!1}function ka(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function iC(){const i=ka("canvas");return i.style.display="block",i}const Ud={};function pr(i){i in Ud||(Ud[i]=!0,console.warn(i))}function sC(i,e,t){return new Promise(function(n,s){function o(){switch(i.clientWaitSync(e,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(o,t);break;default:n()}}setTimeout(o,t)})}function oC(i){const e=i.elements;e[2]=.5*e[2]+.5*e[3],e[6]=.5*e[6]+.5*e[7],e[10]=.5*e[10]+.5*e[11],e[14]=.5*e[14]+.5*e[15]}function rC(i){const e=i.elements;e[11]===-1?(e[10]=-e[10]-1,e[14]=-e[14]):(e[10]=-e[10],e[14]=-e[14]+1)}const gt={enabled:!0,workingColorSpace:qo,spaces:{},convert:function(i,e,t){return this.enabled===!1||e===t||!e||!t||(this.spaces[e].transfer===Rt&&(i.r=Gi(i.r),i.g=Gi(i.g),i.b=Gi(i.b)),this.spaces[e].primaries!==this.spaces[t].primaries&&(i.applyMatrix3(this.spaces[e].toXYZ),i.applyMatrix3(this.spaces[t].fromXYZ)),this.spaces[t].transfer===Rt&&(i.r=Co(i.r),i.g=Co(i.g),i.b=Co(i.b))),i},fromWorkingColorSpace:function(i,e){return this.convert(i,this.workingColorSpace,e)},toWorkingColorSpace:function(i,e){return this.convert(i,e,this.workingColorSpace)},getPrimaries:function(i){return this.spaces[i].primaries},getTransfer:function(i){return i===as?Ka:this.spaces[i].transfer},getLuminanceCoefficients:function(i,e=this.workingColorSpace){return i.fromArray(this.spaces[e].luminanceCoefficients)},define:function(i){Object.assign(this.spaces,i)},_getMatrix:function(i,e,t){return i.copy(this.spaces[e].toXYZ).multiply(this.spaces[t].fromXYZ)},_getDrawingBufferColorSpace:function(i){return this.spaces[i].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(i=this.workingColorSpace){return this.spaces[i].workingColorSpaceConfig.unpackColorSpace}};function Gi(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function Co(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}const kd=[.64,.33,.3,.6,.15,.06],Fd=[.2126,.7152,.0722],Od=[.3127,.329],Bd=new tt().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),zd=new tt().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);gt.define({[qo]:{primaries:kd,whitePoint:Od,transfer:Ka,toXYZ:Bd,fromXYZ:zd,luminanceCoefficients:Fd,workingColorSpaceConfig:{unpackColorSpace:On},outputColorSpaceConfig:{drawingBufferColorSpace:On}},[On]:{primaries:kd,whitePoint:Od,transfer:Rt,toXYZ:Bd,fromXYZ:zd,luminanceCoefficients:Fd,outputColorSpaceConfig:{drawingBufferColorSpace:On}}});let ao;class aC{static getDataURL(e){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let t;if(e instanceof HTMLCanvasElement)t=e;else{ao===void 0&&(ao=ka("canvas")),ao.width=e.width,ao.height=e.height;const n=ao.getContext("2d");e instanceof ImageData?n.putImageData(e,0,0):n.drawImage(e,0,0,e.width,e.height),t=ao}return t.width>2048||t.height>2048?(console.warn("THREE.ImageUtils.getDataURL: Image converted to jpg for performance reasons",e),t.toDataURL("image/jpeg",.6)):t.toDataURL("image/png")}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){const t=ka("canvas");t.width=e.width,t.height=e.height;const n=t.getContext("2d");n.drawImage(e,0,0,e.width,e.height);const s=n.getImageData(0,0,e.width,e.height),o=s.data;for(let r=0;r<o.length;r++)o[r]=Gi(o[r]/255)*255;return n.putImageData(s,0,0),t}else if(e.data){const t=e.data.slice(0);for(let n=0;n<t.length;n++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[n]=Math.floor(Gi(t[n]/255)*255):t[n]=Gi(t[n]);return{data:t,width:e.width,height:e.height}}else return console.warn("THREE.ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}}let lC=0;class _m{constructor(e=null){this.isSource=!0,Object.defineProperty(this,"id",{value:lC++}),this.uuid=Rr(),this.data=e,this.dataReady=!0,this.version=0}set needsUpdate(e){e===!0&&this.version++}toJSON(e){const t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];const n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let o;if(Array.isArray(s)){o=[];for(let r=0,a=s.length;r<a;r++)s[r].isDataTexture?o.push(Tl(s[r].image)):o.push(Tl(s[r]))}else o=Tl(s);n.url=o}return t||(e.images[this.uuid]=n),n}}function Tl(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?aC.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(console.warn("THREE.Texture: Unable to serialize Texture."),{})}let cC=0;class En extends Xo{constructor(e=En.DEFAULT_IMAGE,t=En.DEFAULT_MAPPING,n=Fs,s=Fs,o=bi,r=Os,a=li,l=$i,c=En.DEFAULT_ANISOTROPY,h=as){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:cC++}),this.uuid=Rr(),this.name="",this.source=new _m(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=o,this.minFilter=r,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new vt(0,0),this.repeat=new vt(1,1),this.center=new vt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new tt,this.generateMipmaps=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.version=0,this.onUpdate=null,this.isRenderTargetTexture=!1,this.pmremVersion=0}get image(){return this.source.data}set image(e=null){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}toJSON(e){const t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];const n={metadata:{version:4.6,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),t||(e.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==im)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case Ia:e.x=e.x-Math.floor(e.x);break;case Fs:e.x=e.x<0?0:1;break;case Tc:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case Ia:e.y=e.y-Math.floor(e.y);break;case Fs:e.y=e.y<0?0:1;break;case Tc:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}}En.DEFAULT_IMAGE=null;En.DEFAULT_MAPPING=im;En.DEFAULT_ANISOTROPY=1;class Gt{constructor(e=0,t=0,n=0,s=1){Gt.prototype.isVector4=!0,this.x=e,this.y=t,this.z=n,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,n,s){return this.x=e,this.y=t,this.z=n,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){const t=this.x,n=this.y,s=this.z,o=this.w,r=e.elements;return this.x=r[0]*t+r[4]*n+r[8]*s+r[12]*o,this.y=r[1]*t+r[5]*n+r[9]*s+r[13]*o,this.z=r[2]*t+r[6]*n+r[10]*s+r[14]*o,this.w=r[3]*t+r[7]*n+r[11]*s+r[15]*o,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);const t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,n,s,o;const l=e.elements,c=l[0],h=l[4],u=l[8],d=l[1],m=l[5],g=l[9],_=l[2],p=l[6],f=l[10];if(Math.abs(h-d)<.01&&Math.abs(u-_)<.01&&Math.abs(g-p)<.01){if(Math.abs(h+d)<.1&&Math.abs(u+_)<.1&&Math.abs(g+p)<.1&&Math.abs(c+m+f-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;const S=(c+1)/2,x=(m+1)/2,F=(f+1)/2,P=(h+d)/4,A=(u+_)/4,I=(g+p)/4;return S>x&&S>F?S<.01?(n=0,s=.707106781,o=.707106781):(n=Math.sqrt(S),s=P/n,o=A/n):x>F?x<.01?(n=.707106781,s=0,o=.707106781):(s=Math.sqrt(x),n=P/s,o=I/s):F<.01?(n=.707106781,s=.707106781,o=0):(o=Math.sqrt(F),n=A/o,s=I/o),this.set(n,s,o,t),this}let M=Math.sqrt((p-g)*(p-g)+(u-_)*(u-_)+(d-h)*(d-h));return Math.abs(M)<.001&&(M=1),this.x=(p-g)/M,this.y=(u-_)/M,this.z=(d-h)/M,this.w=Math.acos((c+m+f-1)/2),this}setFromMatrixPosition(e){const t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=Math.max(e.x,Math.min(t.x,this.x)),this.y=Math.max(e.y,Math.min(t.y,this.y)),this.z=Math.max(e.z,Math.min(t.z,this.z)),this.w=Math.max(e.w,Math.min(t.w,this.w)),this}clampScalar(e,t){return this.x=Math.max(e,Math.min(t,this.x)),this.y=Math.max(e,Math.min(t,this.y)),this.z=Math.max(e,Math.min(t,this.z)),this.w=Math.max(e,Math.min(t,this.w)),this}clampLength(e,t){const n=this.length();return this.divideScalar(n||1).multiplyScalar(Math.max(e,Math.min(t,n)))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this.w=e.w+(t.w-e.w)*n,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}}class hC extends Xo{constructor(e=1,t=1,n={}){super(),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=1,this.scissor=new Gt(0,0,e,t),this.scissorTest=!1,this.viewport=new Gt(0,0,e,t);const s={width:e,height:t,depth:1};n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:bi,depthBuffer:!0,stencilBuffer:!1,resolveDepthBuffer:!0,resolveStencilBuffer:!0,depthTexture:null,samples:0,count:1},n);const o=new En(s,n.mapping,n.wrapS,n.wrapT,n.magFilter,n.minFilter,n.format,n.type,n.anisotropy,n.colorSpace);o.flipY=!1,o.generateMipmaps=n.generateMipmaps,o.internalFormat=n.internalFormat,this.textures=[];const r=n.count;for(let a=0;a<r;a++)this.textures[a]=o.clone(),this.textures[a].isRenderTargetTexture=!0;this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.depthTexture=n.depthTexture,this.samples=n.samples}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}setSize(e,t,n=1){if(this.width!==e||this.height!==t||this.depth!==n){this.width=e,this.height=t,this.depth=n;for(let s=0,o=this.textures.length;s<o;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=n;this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let n=0,s=e.textures.length;n<s;n++)this.textures[n]=e.textures[n].clone(),this.textures[n].isRenderTargetTexture=!0;const t=Object.assign({},e.texture.image);return this.texture.source=new _m(t),this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,e.depthTexture!==null&&(this.depthTexture=e.depthTexture.clone()),this.samples=e.samples,this}dispose(){this.dispatchEvent({type:"dispose"})}}class Ws extends hC{constructor(e=1,t=1,n={}){super(e,t,n),this.isWebGLRenderTarget=!0}}class vm extends En{constructor(e=null,t=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=ci,this.minFilter=ci,this.wrapR=Fs,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}}class uC extends En{constructor(e=null,t=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=ci,this.minFilter=ci,this.wrapR=Fs,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}}class Cr{constructor(e=0,t=0,n=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=n,this._w=s}static slerpFlat(e,t,n,s,o,r,a){let l=n[s+0],c=n[s+1],h=n[s+2],u=n[s+3];const d=o[r+0],m=o[r+1],g=o[r+2],_=o[r+3];if(a===0){e[t+0]=l,e[t+1]=c,e[t+2]=h,e[t+3]=u;return}if(a===1){e[t+0]=d,e[t+1]=m,e[t+2]=g,e[t+3]=_;return}if(u!==_||l!==d||c!==m||h!==g){let p=1-a;const f=l*d+c*m+h*g+u*_,M=f>=0?1:-1,S=1-f*f;if(S>Number.EPSILON){const F=Math.sqrt(S),P=Math.atan2(F,f*M);p=Math.sin(p*P)/F,a=Math.sin(a*P)/F}const x=a*M;if(l=l*p+d*x,c=c*p+m*x,h=h*p+g*x,u=u*p+_*x,p===1-a){const F=1/Math.sqrt(l*l+c*c+h*h+u*u);l*=F,c*=F,h*=F,u*=F}}e[t]=l,e[t+1]=c,e[t+2]=h,e[t+3]=u}static multiplyQuaternionsFlat(e,t,n,s,o,r){const a=n[s],l=n[s+1],c=n[s+2],h=n[s+3],u=o[r],d=o[r+1],m=o[r+2],g=o[r+3];return e[t]=a*g+h*u+l*m-c*d,e[t+1]=l*g+h*d+c*u-a*m,e[t+2]=c*g+h*m+a*d-l*u,e[t+3]=h*g-a*u-l*d-c*m,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,n,s){return this._x=e,this._y=t,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){const n=e._x,s=e._y,o=e._z,r=e._order,a=Math.cos,l=Math.sin,c=a(n/2),h=a(s/2),u=a(o/2),d=l(n/2),m=l(s/2),g=l(o/2);switch(r){case"XYZ":this._x=d*h*u+c*m*g,this._y=c*m*u-d*h*g,this._z=c*h*g+d*m*u,this._w=c*h*u-d*m*g;break;case"YXZ":this._x=d*h*u+c*m*g,this._y=c*m*u-d*h*g,this._z=c*h*g-d*m*u,this._w=c*h*u+d*m*g;break;case"ZXY":this._x=d*h*u-c*m*g,this._y=c*m*u+d*h*g,this._z=c*h*g+d*m*u,this._w=c*h*u-d*m*g;break;case"ZYX":this._x=d*h*u-c*m*g,this._y=c*m*u+d*h*g,this._z=c*h*g-d*m*u,this._w=c*h*u+d*m*g;break;case"YZX":this._x=d*h*u+c*m*g,this._y=c*m*u+d*h*g,this._z=c*h*g-d*m*u,this._w=c*h*u-d*m*g;break;case"XZY":this._x=d*h*u-c*m*g,this._y=c*m*u-d*h*g,this._z=c*h*g+d*m*u,this._w=c*h*u+d*m*g;break;default:console.warn("THREE.Quaternion: .setFromEuler() encountered an unknown order: "+r)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){const n=t/2,s=Math.sin(n);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(e){const t=e.elements,n=t[0],s=t[4],o=t[8],r=t[1],a=t[5],l=t[9],c=t[2],h=t[6],u=t[10],d=n+a+u;if(d>0){const m=.5/Math.sqrt(d+1);this._w=.25/m,this._x=(h-l)*m,this._y=(o-c)*m,this._z=(r-s)*m}else if(n>a&&n>u){const m=2*Math.sqrt(1+n-a-u);this._w=(h-l)/m,this._x=.25*m,this._y=(s+r)/m,this._z=(o+c)/m}else if(a>u){const m=2*Math.sqrt(1+a-n-u);this._w=(o-c)/m,this._x=(s+r)/m,this._y=.25*m,this._z=(l+h)/m}else{const m=2*Math.sqrt(1+u-n-a);this._w=(r-s)/m,this._x=(o+c)/m,this._y=(l+h)/m,this._z=.25*m}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let n=e.dot(t)+1;return n<Number.EPSILON?(n=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=n):(this._x=0,this._y=-e.z,this._z=e.y,this._w=n)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=n),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(Cn(this.dot(e),-1,1)))}rotateTowards(e,t){const n=this.angleTo(e);if(n===0)return this;const s=Math.min(1,t/n);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){const n=e._x,s=e._y,o=e._z,r=e._w,a=t._x,l=t._y,c=t._z,h=t._w;return this._x=n*h+r*a+s*c-o*l,this._y=s*h+r*l+o*a-n*c,this._z=o*h+r*c+n*l-s*a,this._w=r*h-n*a-s*l-o*c,this._onChangeCallback(),this}slerp(e,t){if(t===0)return this;if(t===1)return this.copy(e);const n=this._x,s=this._y,o=this._z,r=this._w;let a=r*e._w+n*e._x+s*e._y+o*e._z;if(a<0?(this._w=-e._w,this._x=-e._x,this._y=-e._y,this._z=-e._z,a=-a):this.copy(e),a>=1)return this._w=r,this._x=n,this._y=s,this._z=o,this;const l=1-a*a;if(l<=Number.EPSILON){const m=1-t;return this._w=m*r+t*this._w,this._x=m*n+t*this._x,this._y=m*s+t*this._y,this._z=m*o+t*this._z,this.normalize(),this}const c=Math.sqrt(l),h=Math.atan2(c,a),u=Math.sin((1-t)*h)/c,d=Math.sin(t*h)/c;return this._w=r*u+this._w*d,this._x=n*u+this._x*d,this._y=s*u+this._y*d,this._z=o*u+this._z*d,this._onChangeCallback(),this}slerpQuaternions(e,t,n){return this.copy(e).slerp(t,n)}random(){const e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),o=Math.sqrt(n);return this.set(s*Math.sin(e),s*Math.cos(e),o*Math.sin(t),o*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}}class ee{constructor(e=0,t=0,n=0){ee.prototype.isVector3=!0,this.x=e,this.y=t,this.z=n}set(e,t,n){return n===void 0&&(n=this.z),this.x=e,this.y=t,this.z=n,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(Hd.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(Hd.setFromAxisAngle(e,t))}applyMatrix3(e){const t=this.x,n=this.y,s=this.z,o=e.elements;return this.x=o[0]*t+o[3]*n+o[6]*s,this.y=o[1]*t+o[4]*n+o[7]*s,this.z=o[2]*t+o[5]*n+o[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){const t=this.x,n=this.y,s=this.z,o=e.elements,r=1/(o[3]*t+o[7]*n+o[11]*s+o[15]);return this.x=(o[0]*t+o[4]*n+o[8]*s+o[12])*r,this.y=(o[1]*t+o[5]*n+o[9]*s+o[13])*r,this.z=(o[2]*t+o[6]*n+o[10]*s+o[14])*r,this}applyQuaternion(e){const t=this.x,n=this.y,s=this.z,o=e.x,r=e.y,a=e.z,l=e.w,c=2*(r*s-a*n),h=2*(a*t-o*s),u=2*(o*n-r*t);return this.x=t+l*c+r*u-a*h,this.y=n+l*h+a*c-o*u,this.z=s+l*u+o*h-r*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){const t=this.x,n=this.y,s=this.z,o=e.elements;return this.x=o[0]*t+o[4]*n+o[8]*s,this.y=o[1]*t+o[5]*n+o[9]*s,this.z=o[2]*t+o[6]*n+o[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=Math.max(e.x,Math.min(t.x,this.x)),this.y=Math.max(e.y,Math.min(t.y,this.y)),this.z=Math.max(e.z,Math.min(t.z,this.z)),this}clampScalar(e,t){return this.x=Math.max(e,Math.min(t,this.x)),this.y=Math.max(e,Math.min(t,this.y)),this.z=Math.max(e,Math.min(t,this.z)),this}clampLength(e,t){const n=this.length();return this.divideScalar(n||1).multiplyScalar(Math.max(e,Math.min(t,n)))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){const n=e.x,s=e.y,o=e.z,r=t.x,a=t.y,l=t.z;return this.x=s*l-o*a,this.y=o*r-n*l,this.z=n*a-s*r,this}projectOnVector(e){const t=e.lengthSq();if(t===0)return this.set(0,0,0);const n=e.dot(this)/t;return this.copy(e).multiplyScalar(n)}projectOnPlane(e){return Al.copy(this).projectOnVector(e),this.sub(Al)}reflect(e){return this.sub(Al.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){const t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;const n=this.dot(e)/t;return Math.acos(Cn(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){const t=this.x-e.x,n=this.y-e.y,s=this.z-e.z;return t*t+n*n+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,n){const s=Math.sin(t)*e;return this.x=s*Math.sin(n),this.y=Math.cos(t)*e,this.z=s*Math.cos(n),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,n){return this.x=e*Math.sin(t),this.y=n,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){const t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){const t=this.setFromMatrixColumn(e,0).length(),n=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=n,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){const e=Math.random()*Math.PI*2,t=Math.random()*2-1,n=Math.sqrt(1-t*t);return this.x=n*Math.cos(e),this.y=t,this.z=n*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}}const Al=new ee,Hd=new Cr;class Pr{constructor(e=new ee(1/0,1/0,1/0),t=new ee(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t+=3)this.expandByPoint(ei.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,n=e.count;t<n;t++)this.expandByPoint(ei.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){const n=ei.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(n),this.max.copy(e).add(n),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);const n=e.geometry;if(n!==void 0){const o=n.getAttribute("position");if(t===!0&&o!==void 0&&e.isInstancedMesh!==!0)for(let r=0,a=o.count;r<a;r++)e.isMesh===!0?e.getVertexPosition(r,ei):ei.fromBufferAttribute(o,r),ei.applyMatrix4(e.matrixWorld),this.expandByPoint(ei);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),jr.copy(e.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),jr.copy(n.boundingBox)),jr.applyMatrix4(e.matrixWorld),this.union(jr)}const s=e.children;for(let o=0,r=s.length;o<r;o++)this.expandByObject(s[o],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,ei),ei.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,n;return e.normal.x>0?(t=e.normal.x*this.min.x,n=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,n=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,n+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,n+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,n+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,n+=e.normal.z*this.min.z),t<=-e.constant&&n>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(or),Yr.subVectors(this.max,or),lo.subVectors(e.a,or),co.subVectors(e.b,or),ho.subVectors(e.c,or),Zi.subVectors(co,lo),Ji.subVectors(ho,co),Ss.subVectors(lo,ho);let t=[0,-Zi.z,Zi.y,0,-Ji.z,Ji.y,0,-Ss.z,Ss.y,Zi.z,0,-Zi.x,Ji.z,0,-Ji.x,Ss.z,0,-Ss.x,-Zi.y,Zi.x,0,-Ji.y,Ji.x,0,-Ss.y,Ss.x,0];return!Rl(t,lo,co,ho,Yr)||(t=[1,0,0,0,1,0,0,0,1],!Rl(t,lo,co,ho,Yr))?!1:(Kr.crossVectors(Zi,Ji),t=[Kr.x,Kr.y,Kr.z],Rl(t,lo,co,ho,Yr))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,ei).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(ei).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(Pi[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),Pi[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),Pi[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),Pi[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),Pi[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),Pi[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),Pi[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),Pi[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(Pi),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}}const Pi=[new ee,new ee,new ee,new ee,new ee,new ee,new ee,new ee],ei=new ee,jr=new Pr,lo=new ee,co=new ee,ho=new ee,Zi=new ee,Ji=new ee,Ss=new ee,or=new ee,Yr=new ee,Kr=new ee,ws=new ee;function Rl(i,e,t,n,s){for(let o=0,r=i.length-3;o<=r;o+=3){ws.fromArray(i,o);const a=s.x*Math.abs(ws.x)+s.y*Math.abs(ws.y)+s.z*Math.abs(ws.z),l=e.dot(ws),c=t.dot(ws),h=n.dot(ws);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>a)return!1}return!0}const dC=new Pr,rr=new ee,Cl=new ee;class Fh{constructor(e=new ee,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){const n=this.center;t!==void 0?n.copy(t):dC.setFromPoints(e).getCenter(n);let s=0;for(let o=0,r=e.length;o<r;o++)s=Math.max(s,n.distanceToSquared(e[o]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){const t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){const n=this.center.distanceToSquared(e);return t.copy(e),n>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;rr.subVectors(e,this.center);const t=rr.lengthSq();if(t>this.radius*this.radius){const n=Math.sqrt(t),s=(n-this.radius)*.5;this.center.addScaledVector(rr,s/n),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(Cl.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(rr.copy(e.center).add(Cl)),this.expandByPoint(rr.copy(e.center).sub(Cl))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}}const Li=new ee,Pl=new ee,Zr=new ee,Qi=new ee,Ll=new ee,Jr=new ee,Nl=new ee;class xm{constructor(e=new ee,t=new ee(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,Li)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);const n=t.dot(this.direction);return n<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){const t=Li.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(Li.copy(this.origin).addScaledVector(this.direction,t),Li.distanceToSquared(e))}distanceSqToSegment(e,t,n,s){Pl.copy(e).add(t).multiplyScalar(.5),Zr.copy(t).sub(e).normalize(),Qi.copy(this.origin).sub(Pl);const o=e.distanceTo(t)*.5,r=-this.direction.dot(Zr),a=Qi.dot(this.direction),l=-Qi.dot(Zr),c=Qi.lengthSq(),h=Math.abs(1-r*r);let u,d,m,g;if(h>0)if(u=r*l-a,d=r*a-l,g=o*h,u>=0)if(d>=-g)if(d<=g){const _=1/h;u*=_,d*=_,m=u*(u+r*d+2*a)+d*(r*u+d+2*l)+c}else d=o,u=Math.max(0,-(r*d+a)),m=-u*u+d*(d+2*l)+c;else d=-o,u=Math.max(0,-(r*d+a)),m=-u*u+d*(d+2*l)+c;else d<=-g?(u=Math.max(0,-(-r*o+a)),d=u>0?-o:Math.min(Math.max(-o,-l),o),m=-u*u+d*(d+2*l)+c):d<=g?(u=0,d=Math.min(Math.max(-o,-l),o),m=d*(d+2*l)+c):(u=Math.max(0,-(r*o+a)),d=u>0?o:Math.min(Math.max(-o,-l),o),m=-u*u+d*(d+2*l)+c);else d=r>0?-o:o,u=Math.max(0,-(r*d+a)),m=-u*u+d*(d+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,u),s&&s.copy(Pl).addScaledVector(Zr,d),m}intersectSphere(e,t){Li.subVectors(e.center,this.origin);const n=Li.dot(this.direction),s=Li.dot(Li)-n*n,o=e.radius*e.radius;if(s>o)return null;const r=Math.sqrt(o-s),a=n-r,l=n+r;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){const t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;const n=-(this.origin.dot(e.normal)+e.constant)/t;return n>=0?n:null}intersectPlane(e,t){const n=this.distanceToPlane(e);return n===null?null:this.at(n,t)}intersectsPlane(e){const t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let n,s,o,r,a,l;const c=1/this.direction.x,h=1/this.direction.y,u=1/this.direction.z,d=this.origin;return c>=0?(n=(e.min.x-d.x)*c,s=(e.max.x-d.x)*c):(n=(e.max.x-d.x)*c,s=(e.min.x-d.x)*c),h>=0?(o=(e.min.y-d.y)*h,r=(e.max.y-d.y)*h):(o=(e.max.y-d.y)*h,r=(e.min.y-d.y)*h),n>r||o>s||((o>n||isNaN(n))&&(n=o),(r<s||isNaN(s))&&(s=r),u>=0?(a=(e.min.z-d.z)*u,l=(e.max.z-d.z)*u):(a=(e.max.z-d.z)*u,l=(e.min.z-d.z)*u),n>l||a>s)||((a>n||n!==n)&&(n=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(n>=0?n:s,t)}intersectsBox(e){return this.intersectBox(e,Li)!==null}intersectTriangle(e,t,n,s,o){Ll.subVectors(t,e),Jr.subVectors(n,e),Nl.crossVectors(Ll,Jr);let r=this.direction.dot(Nl),a;if(r>0){if(s)return null;a=1}else if(r<0)a=-1,r=-r;else return null;Qi.subVectors(this.origin,e);const l=a*this.direction.dot(Jr.crossVectors(Qi,Jr));if(l<0)return null;const c=a*this.direction.dot(Ll.cross(Qi));if(c<0||l+c>r)return null;const h=-a*Qi.dot(Nl);return h<0?null:this.at(h/r,o)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}}class zt{constructor(e,t,n,s,o,r,a,l,c,h,u,d,m,g,_,p){zt.prototype.isMatrix4=!0,this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,n,s,o,r,a,l,c,h,u,d,m,g,_,p)}set(e,t,n,s,o,r,a,l,c,h,u,d,m,g,_,p){const f=this.elements;return f[0]=e,f[4]=t,f[8]=n,f[12]=s,f[1]=o,f[5]=r,f[9]=a,f[13]=l,f[2]=c,f[6]=h,f[10]=u,f[14]=d,f[3]=m,f[7]=g,f[11]=_,f[15]=p,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new zt().fromArray(this.elements)}copy(e){const t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],t[9]=n[9],t[10]=n[10],t[11]=n[11],t[12]=n[12],t[13]=n[13],t[14]=n[14],t[15]=n[15],this}copyPosition(e){const t=this.elements,n=e.elements;return t[12]=n[12],t[13]=n[13],t[14]=n[14],this}setFromMatrix3(e){const t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,n){return e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this}makeBasis(e,t,n){return this.set(e.x,t.x,n.x,0,e.y,t.y,n.y,0,e.z,t.z,n.z,0,0,0,0,1),this}extractRotation(e){const t=this.elements,n=e.elements,s=1/uo.setFromMatrixColumn(e,0).length(),o=1/uo.setFromMatrixColumn(e,1).length(),r=1/uo.setFromMatrixColumn(e,2).length();return t[0]=n[0]*s,t[1]=n[1]*s,t[2]=n[2]*s,t[3]=0,t[4]=n[4]*o,t[5]=n[5]*o,t[6]=n[6]*o,t[7]=0,t[8]=n[8]*r,t[9]=n[9]*r,t[10]=n[10]*r,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){const t=this.elements,n=e.x,s=e.y,o=e.z,r=Math.cos(n),a=Math.sin(n),l=Math.cos(s),c=Math.sin(s),h=Math.cos(o),u=Math.sin(o);if(e.order==="XYZ"){const d=r*h,m=r*u,g=a*h,_=a*u;t[0]=l*h,t[4]=-l*u,t[8]=c,t[1]=m+g*c,t[5]=d-_*c,t[9]=-a*l,t[2]=_-d*c,t[6]=g+m*c,t[10]=r*l}else if(e.order==="YXZ"){const d=l*h,m=l*u,g=c*h,_=c*u;t[0]=d+_*a,t[4]=g*a-m,t[8]=r*c,t[1]=r*u,t[5]=r*h,t[9]=-a,t[2]=m*a-g,t[6]=_+d*a,t[10]=r*l}else if(e.order==="ZXY"){const d=l*h,m=l*u,g=c*h,_=c*u;t[0]=d-_*a,t[4]=-r*u,t[8]=g+m*a,t[1]=m+g*a,t[5]=r*h,t[9]=_-d*a,t[2]=-r*c,t[6]=a,t[10]=r*l}else if(e.order==="ZYX"){const d=r*h,m=r*u,g=a*h,_=a*u;t[0]=l*h,t[4]=g*c-m,t[8]=d*c+_,t[1]=l*u,t[5]=_*c+d,t[9]=m*c-g,t[2]=-c,t[6]=a*l,t[10]=r*l}else if(e.order==="YZX"){const d=r*l,m=r*c,g=a*l,_=a*c;t[0]=l*h,t[4]=_-d*u,t[8]=g*u+m,t[1]=u,t[5]=r*h,t[9]=-a*h,t[2]=-c*h,t[6]=m*u+g,t[10]=d-_*u}else if(e.order==="XZY"){const d=r*l,m=r*c,g=a*l,_=a*c;t[0]=l*h,t[4]=-u,t[8]=c*h,t[1]=d*u+_,t[5]=r*h,t[9]=m*u-g,t[2]=g*u-m,t[6]=a*h,t[10]=_*u+d}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(fC,e,pC)}lookAt(e,t,n){const s=this.elements;return Un.subVectors(e,t),Un.lengthSq()===0&&(Un.z=1),Un.normalize(),es.crossVectors(n,Un),es.lengthSq()===0&&(Math.abs(n.z)===1?Un.x+=1e-4:Un.z+=1e-4,Un.normalize(),es.crossVectors(n,Un)),es.normalize(),Qr.crossVectors(Un,es),s[0]=es.x,s[4]=Qr.x,s[8]=Un.x,s[1]=es.y,s[5]=Qr.y,s[9]=Un.y,s[2]=es.z,s[6]=Qr.z,s[10]=Un.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){const n=e.elements,s=t.elements,o=this.elements,r=n[0],a=n[4],l=n[8],c=n[12],h=n[1],u=n[5],d=n[9],m=n[13],g=n[2],_=n[6],p=n[10],f=n[14],M=n[3],S=n[7],x=n[11],F=n[15],P=s[0],A=s[4],I=s[8],E=s[12],y=s[1],R=s[5],V=s[9],O=s[13],$=s[2],q=s[6],X=s[10],Y=s[14],te=s[3],le=s[7],he=s[11],_e=s[15];return o[0]=r*P+a*y+l*$+c*te,o[4]=r*A+a*R+l*q+c*le,o[8]=r*I+a*V+l*X+c*he,o[12]=r*E+a*O+l*Y+c*_e,o[1]=h*P+u*y+d*$+m*te,o[5]=h*A+u*R+d*q+m*le,o[9]=h*I+u*V+d*X+m*he,o[13]=h*E+u*O+d*Y+m*_e,o[2]=g*P+_*y+p*$+f*te,o[6]=g*A+_*R+p*q+f*le,o[10]=g*I+_*V+p*X+f*he,o[14]=g*E+_*O+p*Y+f*_e,o[3]=M*P+S*y+x*$+F*te,o[7]=M*A+S*R+x*q+F*le,o[11]=M*I+S*V+x*X+F*he,o[15]=M*E+S*O+x*Y+F*_e,this}multiplyScalar(e){const t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){const e=this.elements,t=e[0],n=e[4],s=e[8],o=e[12],r=e[1],a=e[5],l=e[9],c=e[13],h=e[2],u=e[6],d=e[10],m=e[14],g=e[3],_=e[7],p=e[11],f=e[15];return g*(+o*l*u-s*c*u-o*a*d+n*c*d+s*a*m-n*l*m)+_*(+t*l*m-t*c*d+o*r*d-s*r*m+s*c*h-o*l*h)+p*(+t*c*u-t*a*m-o*r*u+n*r*m+o*a*h-n*c*h)+f*(-s*a*h-t*l*u+t*a*d+s*r*u-n*r*d+n*l*h)}transpose(){const e=this.elements;let t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,n){const s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=n),this}invert(){const e=this.elements,t=e[0],n=e[1],s=e[2],o=e[3],r=e[4],a=e[5],l=e[6],c=e[7],h=e[8],u=e[9],d=e[10],m=e[11],g=e[12],_=e[13],p=e[14],f=e[15],M=u*p*c-_*d*c+_*l*m-a*p*m-u*l*f+a*d*f,S=g*d*c-h*p*c-g*l*m+r*p*m+h*l*f-r*d*f,x=h*_*c-g*u*c+g*a*m-r*_*m-h*a*f+r*u*f,F=g*u*l-h*_*l-g*a*d+r*_*d+h*a*p-r*u*p,P=t*M+n*S+s*x+o*F;if(P===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);const A=1/P;return e[0]=M*A,e[1]=(_*d*o-u*p*o-_*s*m+n*p*m+u*s*f-n*d*f)*A,e[2]=(a*p*o-_*l*o+_*s*c-n*p*c-a*s*f+n*l*f)*A,e[3]=(u*l*o-a*d*o-u*s*c+n*d*c+a*s*m-n*l*m)*A,e[4]=S*A,e[5]=(h*p*o-g*d*o+g*s*m-t*p*m-h*s*f+t*d*f)*A,e[6]=(g*l*o-r*p*o-g*s*c+t*p*c+r*s*f-t*l*f)*A,e[7]=(r*d*o-h*l*o+h*s*c-t*d*c-r*s*m+t*l*m)*A,e[8]=x*A,e[9]=(g*u*o-h*_*o-g*n*m+t*_*m+h*n*f-t*u*f)*A,e[10]=(r*_*o-g*a*o+g*n*c-t*_*c-r*n*f+t*a*f)*A,e[11]=(h*a*o-r*u*o-h*n*c+t*u*c+r*n*m-t*a*m)*A,e[12]=F*A,e[13]=(h*_*s-g*u*s+g*n*d-t*_*d-h*n*p+t*u*p)*A,e[14]=(g*a*s-r*_*s-g*n*l+t*_*l+r*n*p-t*a*p)*A,e[15]=(r*u*s-h*a*s+h*n*l-t*u*l-r*n*d+t*a*d)*A,this}scale(e){const t=this.elements,n=e.x,s=e.y,o=e.z;return t[0]*=n,t[4]*=s,t[8]*=o,t[1]*=n,t[5]*=s,t[9]*=o,t[2]*=n,t[6]*=s,t[10]*=o,t[3]*=n,t[7]*=s,t[11]*=o,this}getMaxScaleOnAxis(){const e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],n=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,n,s))}makeTranslation(e,t,n){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,n,0,0,0,1),this}makeRotationX(e){const t=Math.cos(e),n=Math.sin(e);return this.set(1,0,0,0,0,t,-n,0,0,n,t,0,0,0,0,1),this}makeRotationY(e){const t=Math.cos(e),n=Math.sin(e);return this.set(t,0,n,0,0,1,0,0,-n,0,t,0,0,0,0,1),this}makeRotationZ(e){const t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,0,n,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){const n=Math.cos(t),s=Math.sin(t),o=1-n,r=e.x,a=e.y,l=e.z,c=o*r,h=o*a;return this.set(c*r+n,c*a-s*l,c*l+s*a,0,c*a+s*l,h*a+n,h*l-s*r,0,c*l-s*a,h*l+s*r,o*l*l+n,0,0,0,0,1),this}makeScale(e,t,n){return this.set(e,0,0,0,0,t,0,0,0,0,n,0,0,0,0,1),this}makeShear(e,t,n,s,o,r){return this.set(1,n,o,0,e,1,r,0,t,s,1,0,0,0,0,1),this}compose(e,t,n){const s=this.elements,o=t._x,r=t._y,a=t._z,l=t._w,c=o+o,h=r+r,u=a+a,d=o*c,m=o*h,g=o*u,_=r*h,p=r*u,f=a*u,M=l*c,S=l*h,x=l*u,F=n.x,P=n.y,A=n.z;return s[0]=(1-(_+f))*F,s[1]=(m+x)*F,s[2]=(g-S)*F,s[3]=0,s[4]=(m-x)*P,s[5]=(1-(d+f))*P,s[6]=(p+M)*P,s[7]=0,s[8]=(g+S)*A,s[9]=(p-M)*A,s[10]=(1-(d+_))*A,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,n){const s=this.elements;let o=uo.set(s[0],s[1],s[2]).length();const r=uo.set(s[4],s[5],s[6]).length(),a=uo.set(s[8],s[9],s[10]).length();this.determinant()<0&&(o=-o),e.x=s[12],e.y=s[13],e.z=s[14],ti.copy(this);const c=1/o,h=1/r,u=1/a;return ti.elements[0]*=c,ti.elements[1]*=c,ti.elements[2]*=c,ti.elements[4]*=h,ti.elements[5]*=h,ti.elements[6]*=h,ti.elements[8]*=u,ti.elements[9]*=u,ti.elements[10]*=u,t.setFromRotationMatrix(ti),n.x=o,n.y=r,n.z=a,this}makePerspective(e,t,n,s,o,r,a=Bi){const l=this.elements,c=2*o/(t-e),h=2*o/(n-s),u=(t+e)/(t-e),d=(n+s)/(n-s);let m,g;if(a===Bi)m=-(r+o)/(r-o),g=-2*r*o/(r-o);else if(a===Ua)m=-r/(r-o),g=-r*o/(r-o);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return l[0]=c,l[4]=0,l[8]=u,l[12]=0,l[1]=0,l[5]=h,l[9]=d,l[13]=0,l[2]=0,l[6]=0,l[10]=m,l[14]=g,l[3]=0,l[7]=0,l[11]=-1,l[15]=0,this}makeOrthographic(e,t,n,s,o,r,a=Bi){const l=this.elements,c=1/(t-e),h=1/(n-s),u=1/(r-o),d=(t+e)*c,m=(n+s)*h;let g,_;if(a===Bi)g=(r+o)*u,_=-2*u;else if(a===Ua)g=o*u,_=-1*u;else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return l[0]=2*c,l[4]=0,l[8]=0,l[12]=-d,l[1]=0,l[5]=2*h,l[9]=0,l[13]=-m,l[2]=0,l[6]=0,l[10]=_,l[14]=-g,l[3]=0,l[7]=0,l[11]=0,l[15]=1,this}equals(e){const t=this.elements,n=e.elements;for(let s=0;s<16;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<16;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){const n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e[t+9]=n[9],e[t+10]=n[10],e[t+11]=n[11],e[t+12]=n[12],e[t+13]=n[13],e[t+14]=n[14],e[t+15]=n[15],e}}const uo=new ee,ti=new zt,fC=new ee(0,0,0),pC=new ee(1,1,1),es=new ee,Qr=new ee,Un=new ee,Vd=new zt,Gd=new Cr;class Ei{constructor(e=0,t=0,n=0,s=Ei.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=n,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,n,s=this._order){return this._x=e,this._y=t,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,n=!0){const s=e.elements,o=s[0],r=s[4],a=s[8],l=s[1],c=s[5],h=s[9],u=s[2],d=s[6],m=s[10];switch(t){case"XYZ":this._y=Math.asin(Cn(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,m),this._z=Math.atan2(-r,o)):(this._x=Math.atan2(d,c),this._z=0);break;case"YXZ":this._x=Math.asin(-Cn(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,m),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-u,o),this._z=0);break;case"ZXY":this._x=Math.asin(Cn(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-u,m),this._z=Math.atan2(-r,c)):(this._y=0,this._z=Math.atan2(l,o));break;case"ZYX":this._y=Math.asin(-Cn(u,-1,1)),Math.abs(u)<.9999999?(this._x=Math.atan2(d,m),this._z=Math.atan2(l,o)):(this._x=0,this._z=Math.atan2(-r,c));break;case"YZX":this._z=Math.asin(Cn(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-u,o)):(this._x=0,this._y=Math.atan2(a,m));break;case"XZY":this._z=Math.asin(-Cn(r,-1,1)),Math.abs(r)<.9999999?(this._x=Math.atan2(d,c),this._y=Math.atan2(a,o)):(this._x=Math.atan2(-h,m),this._y=0);break;default:console.warn("THREE.Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,n===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,n){return Vd.makeRotationFromQuaternion(e),this.setFromRotationMatrix(Vd,t,n)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return Gd.setFromEuler(this),this.setFromQuaternion(Gd,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}}Ei.DEFAULT_ORDER="XYZ";class Oh{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}}let mC=0;const Wd=new ee,fo=new Cr,Ni=new zt,ea=new ee,ar=new ee,gC=new ee,_C=new Cr,$d=new ee(1,0,0),qd=new ee(0,1,0),Xd=new ee(0,0,1),jd={type:"added"},vC={type:"removed"},po={type:"childadded",child:null},Dl={type:"childremoved",child:null};class dn extends Xo{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:mC++}),this.uuid=Rr(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=dn.DEFAULT_UP.clone();const e=new ee,t=new Ei,n=new Cr,s=new ee(1,1,1);function o(){n.setFromEuler(t,!1)}function r(){t.setFromQuaternion(n,void 0,!1)}t._onChange(o),n._onChange(r),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new zt},normalMatrix:{value:new tt}}),this.matrix=new zt,this.matrixWorld=new zt,this.matrixAutoUpdate=dn.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=dn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Oh,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.userData={}}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return fo.setFromAxisAngle(e,t),this.quaternion.multiply(fo),this}rotateOnWorldAxis(e,t){return fo.setFromAxisAngle(e,t),this.quaternion.premultiply(fo),this}rotateX(e){return this.rotateOnAxis($d,e)}rotateY(e){return this.rotateOnAxis(qd,e)}rotateZ(e){return this.rotateOnAxis(Xd,e)}translateOnAxis(e,t){return Wd.copy(e).applyQuaternion(this.quaternion),this.position.add(Wd.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis($d,e)}translateY(e){return this.translateOnAxis(qd,e)}translateZ(e){return this.translateOnAxis(Xd,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(Ni.copy(this.matrixWorld).invert())}lookAt(e,t,n){e.isVector3?ea.copy(e):ea.set(e,t,n);const s=this.parent;this.updateWorldMatrix(!0,!1),ar.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Ni.lookAt(ar,ea,this.up):Ni.lookAt(ea,ar,this.up),this.quaternion.setFromRotationMatrix(Ni),s&&(Ni.extractRotation(s.matrixWorld),fo.setFromRotationMatrix(Ni),this.quaternion.premultiply(fo.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(console.error("THREE.Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(jd),po.child=e,this.dispatchEvent(po),po.child=null):console.error("THREE.Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}const t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(vC),Dl.child=e,this.dispatchEvent(Dl),Dl.child=null),this}removeFromParent(){const e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),Ni.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),Ni.multiply(e.parent.matrixWorld)),e.applyMatrix4(Ni),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(jd),po.child=e,this.dispatchEvent(po),po.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let n=0,s=this.children.length;n<s;n++){const r=this.children[n].getObjectByProperty(e,t);if(r!==void 0)return r}}getObjectsByProperty(e,t,n=[]){this[e]===t&&n.push(this);const s=this.children;for(let o=0,r=s.length;o<r;o++)s[o].getObjectsByProperty(e,t,n);return n}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ar,e,gC),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ar,_C,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);const t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}traverse(e){e(this);const t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);const t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverseVisible(e)}traverseAncestors(e){const t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale),this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);const t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].updateMatrixWorld(e)}updateWorldMatrix(e,t){const n=this.parent;if(e===!0&&n!==null&&n.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),t===!0){const s=this.children;for(let o=0,r=s.length;o<r;o++)s[o].updateWorldMatrix(!1,!0)}}toJSON(e){const t=e===void 0||typeof e=="string",n={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.6,type:"Object",generator:"Object3D.toJSON"});const s={};s.uuid=this.uuid,s.type=this.type,this.name!==""&&(s.name=this.name),this.castShadow===!0&&(s.castShadow=!0),this.receiveShadow===!0&&(s.receiveShadow=!0),this.visible===!1&&(s.visible=!1),this.frustumCulled===!1&&(s.frustumCulled=!1),this.renderOrder!==0&&(s.renderOrder=this.renderOrder),Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.matrixAutoUpdate===!1&&(s.matrixAutoUpdate=!1),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.visibility=this._visibility,s.active=this._active,s.bounds=this._bounds.map(a=>({boxInitialized:a.boxInitialized,boxMin:a.box.min.toArray(),boxMax:a.box.max.toArray(),sphereInitialized:a.sphereInitialized,sphereRadius:a.sphere.radius,sphereCenter:a.sphere.center.toArray()})),s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.geometryCount=this._geometryCount,s.matricesTexture=this._matricesTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere={center:s.boundingSphere.center.toArray(),radius:s.boundingSphere.radius}),this.boundingBox!==null&&(s.boundingBox={min:s.boundingBox.min.toArray(),max:s.boundingBox.max.toArray()}));function o(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=o(e.geometries,this.geometry);const a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){const l=a.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){const u=l[c];o(e.shapes,u)}else o(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(o(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){const a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(o(e.materials,this.material[l]));s.material=a}else s.material=o(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){const l=this.animations[a];s.animations.push(o(e.animations,l))}}if(t){const a=r(e.geometries),l=r(e.materials),c=r(e.textures),h=r(e.images),u=r(e.shapes),d=r(e.skeletons),m=r(e.animations),g=r(e.nodes);a.length>0&&(n.geometries=a),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),h.length>0&&(n.images=h),u.length>0&&(n.shapes=u),d.length>0&&(n.skeletons=d),m.length>0&&(n.animations=m),g.length>0&&(n.nodes=g)}return n.object=s,n;function r(a){const l=[];for(const c in a){const h=a[c];delete h.metadata,l.push(h)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let n=0;n<e.children.length;n++){const s=e.children[n];this.add(s.clone())}return this}}dn.DEFAULT_UP=new ee(0,1,0);dn.DEFAULT_MATRIX_AUTO_UPDATE=!0;dn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;const ni=new ee,Di=new ee,Il=new ee,Ii=new ee,mo=new ee,go=new ee,Yd=new ee,Ul=new ee,kl=new ee,Fl=new ee,Ol=new Gt,Bl=new Gt,zl=new Gt;class ai{constructor(e=new ee,t=new ee,n=new ee){this.a=e,this.b=t,this.c=n}static getNormal(e,t,n,s){s.subVectors(n,t),ni.subVectors(e,t),s.cross(ni);const o=s.lengthSq();return o>0?s.multiplyScalar(1/Math.sqrt(o)):s.set(0,0,0)}static getBarycoord(e,t,n,s,o){ni.subVectors(s,t),Di.subVectors(n,t),Il.subVectors(e,t);const r=ni.dot(ni),a=ni.dot(Di),l=ni.dot(Il),c=Di.dot(Di),h=Di.dot(Il),u=r*c-a*a;if(u===0)return o.set(0,0,0),null;const d=1/u,m=(c*l-a*h)*d,g=(r*h-a*l)*d;return o.set(1-m-g,g,m)}static containsPoint(e,t,n,s){return this.getBarycoord(e,t,n,s,Ii)===null?!1:Ii.x>=0&&Ii.y>=0&&Ii.x+Ii.y<=1}static getInterpolation(e,t,n,s,o,r,a,l){return this.getBarycoord(e,t,n,s,Ii)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(o,Ii.x),l.addScaledVector(r,Ii.y),l.addScaledVector(a,Ii.z),l)}static getInterpolatedAttribute(e,t,n,s,o,r){return Ol.setScalar(0),Bl.setScalar(0),zl.setScalar(0),Ol.fromBufferAttribute(e,t),Bl.fromBufferAttribute(e,n),zl.fromBufferAttribute(e,s),r.setScalar(0),r.addScaledVector(Ol,o.x),r.addScaledVector(Bl,o.y),r.addScaledVector(zl,o.z),r}static isFrontFacing(e,t,n,s){return ni.subVectors(n,t),Di.subVectors(e,t),ni.cross(Di).dot(s)<0}set(e,t,n){return this.a.copy(e),this.b.copy(t),this.c.copy(n),this}setFromPointsAndIndices(e,t,n,s){return this.a.copy(e[t]),this.b.copy(e[n]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,n,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,n),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return ni.subVectors(this.c,this.b),Di.subVectors(this.a,this.b),ni.cross(Di).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return ai.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return ai.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,n,s,o){return ai.getInterpolation(e,this.a,this.b,this.c,t,n,s,o)}containsPoint(e){return ai.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return ai.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){const n=this.a,s=this.b,o=this.c;let r,a;mo.subVectors(s,n),go.subVectors(o,n),Ul.subVectors(e,n);const l=mo.dot(Ul),c=go.dot(Ul);if(l<=0&&c<=0)return t.copy(n);kl.subVectors(e,s);const h=mo.dot(kl),u=go.dot(kl);if(h>=0&&u<=h)return t.copy(s);const d=l*u-h*c;if(d<=0&&l>=0&&h<=0)return r=l/(l-h),t.copy(n).addScaledVector(mo,r);Fl.subVectors(e,o);const m=mo.dot(Fl),g=go.dot(Fl);if(g>=0&&m<=g)return t.copy(o);const _=m*c-l*g;if(_<=0&&c>=0&&g<=0)return a=c/(c-g),t.copy(n).addScaledVector(go,a);const p=h*g-m*u;if(p<=0&&u-h>=0&&m-g>=0)return Yd.subVectors(o,s),a=(u-h)/(u-h+(m-g)),t.copy(s).addScaledVector(Yd,a);const f=1/(p+_+d);return r=_*f,a=d*f,t.copy(n).addScaledVector(mo,r).addScaledVector(go,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}}const bm={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},ts={h:0,s:0,l:0},ta={h:0,s:0,l:0};function Hl(i,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?i+(e-i)*6*t:t<1/2?e:t<2/3?i+(e-i)*6*(2/3-t):i}class dt{constructor(e,t,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,n)}set(e,t,n){if(t===void 0&&n===void 0){const s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,n);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=On){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,gt.toWorkingColorSpace(this,t),this}setRGB(e,t,n,s=gt.workingColorSpace){return this.r=e,this.g=t,this.b=n,gt.toWorkingColorSpace(this,s),this}setHSL(e,t,n,s=gt.workingColorSpace){if(e=nC(e,1),t=Cn(t,0,1),n=Cn(n,0,1),t===0)this.r=this.g=this.b=n;else{const o=n<=.5?n*(1+t):n+t-n*t,r=2*n-o;this.r=Hl(r,o,e+1/3),this.g=Hl(r,o,e),this.b=Hl(r,o,e-1/3)}return gt.toWorkingColorSpace(this,s),this}setStyle(e,t=On){function n(o){o!==void 0&&parseFloat(o)<1&&console.warn("THREE.Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let o;const r=s[1],a=s[2];switch(r){case"rgb":case"rgba":if(o=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return n(o[4]),this.setRGB(Math.min(255,parseInt(o[1],10))/255,Math.min(255,parseInt(o[2],10))/255,Math.min(255,parseInt(o[3],10))/255,t);if(o=/^\s*(\d+)\%\s*,\s*(\d+)\%\s*,\s*(\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return n(o[4]),this.setRGB(Math.min(100,parseInt(o[1],10))/100,Math.min(100,parseInt(o[2],10))/100,Math.min(100,parseInt(o[3],10))/100,t);break;case"hsl":case"hsla":if(o=/^\s*(\d*\.?\d+)\s*,\s*(\d*\.?\d+)\%\s*,\s*(\d*\.?\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return n(o[4]),this.setHSL(parseFloat(o[1])/360,parseFloat(o[2])/100,parseFloat(o[3])/100,t);break;default:console.warn("THREE.Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){const o=s[1],r=o.length;if(r===3)return this.setRGB(parseInt(o.charAt(0),16)/15,parseInt(o.charAt(1),16)/15,parseInt(o.charAt(2),16)/15,t);if(r===6)return this.setHex(parseInt(o,16),t);console.warn("THREE.Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=On){const n=bm[e.toLowerCase()];return n!==void 0?this.setHex(n,t):console.warn("THREE.Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=Gi(e.r),this.g=Gi(e.g),this.b=Gi(e.b),this}copyLinearToSRGB(e){return this.r=Co(e.r),this.g=Co(e.g),this.b=Co(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=On){return gt.fromWorkingColorSpace(gn.copy(this),e),Math.round(Cn(gn.r*255,0,255))*65536+Math.round(Cn(gn.g*255,0,255))*256+Math.round(Cn(gn.b*255,0,255))}getHexString(e=On){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=gt.workingColorSpace){gt.fromWorkingColorSpace(gn.copy(this),t);const n=gn.r,s=gn.g,o=gn.b,r=Math.max(n,s,o),a=Math.min(n,s,o);let l,c;const h=(a+r)/2;if(a===r)l=0,c=0;else{const u=r-a;switch(c=h<=.5?u/(r+a):u/(2-r-a),r){case n:l=(s-o)/u+(s<o?6:0);break;case s:l=(o-n)/u+2;break;case o:l=(n-s)/u+4;break}l/=6}return e.h=l,e.s=c,e.l=h,e}getRGB(e,t=gt.workingColorSpace){return gt.fromWorkingColorSpace(gn.copy(this),t),e.r=gn.r,e.g=gn.g,e.b=gn.b,e}getStyle(e=On){gt.fromWorkingColorSpace(gn.copy(this),e);const t=gn.r,n=gn.g,s=gn.b;return e!==On?`color(${e} ${t.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(e,t,n){return this.getHSL(ts),this.setHSL(ts.h+e,ts.s+t,ts.l+n)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,n){return this.r=e.r+(t.r-e.r)*n,this.g=e.g+(t.g-e.g)*n,this.b=e.b+(t.b-e.b)*n,this}lerpHSL(e,t){this.getHSL(ts),e.getHSL(ta);const n=wl(ts.h,ta.h,t),s=wl(ts.s,ta.s,t),o=wl(ts.l,ta.l,t);return this.setHSL(n,s,o),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){const t=this.r,n=this.g,s=this.b,o=e.elements;return this.r=o[0]*t+o[3]*n+o[6]*s,this.g=o[1]*t+o[4]*n+o[7]*s,this.b=o[2]*t+o[5]*n+o[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}}const gn=new dt;dt.NAMES=bm;let xC=0;class Lr extends Xo{static get type(){return"Material"}get type(){return this.constructor.type}set type(e){}constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:xC++}),this.uuid=Rr(),this.name="",this.blending=Ao,this.side=ps,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=mc,this.blendDst=gc,this.blendEquation=Us,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new dt(0,0,0),this.blendAlpha=0,this.depthFunc=Uo,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Nd,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=ro,this.stencilZFail=ro,this.stencilZPass=ro,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(const t in e){const n=e[t];if(n===void 0){console.warn(`THREE.Material: parameter '${t}' has value of undefined.`);continue}const s=this[t];if(s===void 0){console.warn(`THREE.Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[t]=n}}toJSON(e){const t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});const n={metadata:{version:4.6,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,this.name!==""&&(n.name=this.name),this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&this.emissiveIntensity!==1&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessRange!==void 0&&(n.iridescenceThicknessRange=this.iridescenceThicknessRange),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(e).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(e).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(e).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(e).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(e).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&this.attenuationDistance!==1/0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.shadowSide!==null&&(n.shadowSide=this.shadowSide),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),this.blending!==Ao&&(n.blending=this.blending),this.side!==ps&&(n.side=this.side),this.vertexColors===!0&&(n.vertexColors=!0),this.opacity<1&&(n.opacity=this.opacity),this.transparent===!0&&(n.transparent=!0),this.blendSrc!==mc&&(n.blendSrc=this.blendSrc),this.blendDst!==gc&&(n.blendDst=this.blendDst),this.blendEquation!==Us&&(n.blendEquation=this.blendEquation),this.blendSrcAlpha!==null&&(n.blendSrcAlpha=this.blendSrcAlpha),this.blendDstAlpha!==null&&(n.blendDstAlpha=this.blendDstAlpha),this.blendEquationAlpha!==null&&(n.blendEquationAlpha=this.blendEquationAlpha),this.blendColor&&this.blendColor.isColor&&(n.blendColor=this.blendColor.getHex()),this.blendAlpha!==0&&(n.blendAlpha=this.blendAlpha),this.depthFunc!==Uo&&(n.depthFunc=this.depthFunc),this.depthTest===!1&&(n.depthTest=this.depthTest),this.depthWrite===!1&&(n.depthWrite=this.depthWrite),this.colorWrite===!1&&(n.colorWrite=this.colorWrite),this.stencilWriteMask!==255&&(n.stencilWriteMask=this.stencilWriteMask),this.stencilFunc!==Nd&&(n.stencilFunc=this.stencilFunc),this.stencilRef!==0&&(n.stencilRef=this.stencilRef),this.stencilFuncMask!==255&&(n.stencilFuncMask=this.stencilFuncMask),this.stencilFail!==ro&&(n.stencilFail=this.stencilFail),this.stencilZFail!==ro&&(n.stencilZFail=this.stencilZFail),this.stencilZPass!==ro&&(n.stencilZPass=this.stencilZPass),this.stencilWrite===!0&&(n.stencilWrite=this.stencilWrite),this.rotation!==void 0&&this.rotation!==0&&(n.rotation=this.rotation),this.polygonOffset===!0&&(n.polygonOffset=!0),this.polygonOffsetFactor!==0&&(n.polygonOffsetFactor=this.polygonOffsetFactor),this.polygonOffsetUnits!==0&&(n.polygonOffsetUnits=this.polygonOffsetUnits),this.linewidth!==void 0&&this.linewidth!==1&&(n.linewidth=this.linewidth),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.dithering===!0&&(n.dithering=!0),this.alphaTest>0&&(n.alphaTest=this.alphaTest),this.alphaHash===!0&&(n.alphaHash=!0),this.alphaToCoverage===!0&&(n.alphaToCoverage=!0),this.premultipliedAlpha===!0&&(n.premultipliedAlpha=!0),this.forceSinglePass===!0&&(n.forceSinglePass=!0),this.wireframe===!0&&(n.wireframe=!0),this.wireframeLinewidth>1&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!=="round"&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!=="round"&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading===!0&&(n.flatShading=!0),this.visible===!1&&(n.visible=!1),this.toneMapped===!1&&(n.toneMapped=!1),this.fog===!1&&(n.fog=!1),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(o){const r=[];for(const a in o){const l=o[a];delete l.metadata,r.push(l)}return r}if(t){const o=s(e.textures),r=s(e.images);o.length>0&&(n.textures=o),r.length>0&&(n.images=r)}return n}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;const t=e.clippingPlanes;let n=null;if(t!==null){const s=t.length;n=new Array(s);for(let o=0;o!==s;++o)n[o]=t[o].clone()}return this.clippingPlanes=n,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}onBuild(){console.warn("Material: onBuild() has been removed.")}}class Bh extends Lr{static get type(){return"MeshBasicMaterial"}constructor(e){super(),this.isMeshBasicMaterial=!0,this.color=new dt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ei,this.combine=nm,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}}const Xt=new ee,na=new vt;class Mi{constructor(e,t,n=!1){if(Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=n,this.usage=Dd,this.updateRanges=[],this.gpuType=Oi,this.version=0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this}copyAt(e,t,n){e*=this.itemSize,n*=t.itemSize;for(let s=0,o=this.itemSize;s<o;s++)this.array[e+s]=t.array[n+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,n=this.count;t<n;t++)na.fromBufferAttribute(this,t),na.applyMatrix3(e),this.setXY(t,na.x,na.y);else if(this.itemSize===3)for(let t=0,n=this.count;t<n;t++)Xt.fromBufferAttribute(this,t),Xt.applyMatrix3(e),this.setXYZ(t,Xt.x,Xt.y,Xt.z);return this}applyMatrix4(e){for(let t=0,n=this.count;t<n;t++)Xt.fromBufferAttribute(this,t),Xt.applyMatrix4(e),this.setXYZ(t,Xt.x,Xt.y,Xt.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)Xt.fromBufferAttribute(this,t),Xt.applyNormalMatrix(e),this.setXYZ(t,Xt.x,Xt.y,Xt.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)Xt.fromBufferAttribute(this,t),Xt.transformDirection(e),this.setXYZ(t,Xt.x,Xt.y,Xt.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let n=this.array[e*this.itemSize+t];return this.normalized&&(n=sr(n,this.array)),n}setComponent(e,t,n){return this.normalized&&(n=Rn(n,this.array)),this.array[e*this.itemSize+t]=n,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=sr(t,this.array)),t}setX(e,t){return this.normalized&&(t=Rn(t,this.array)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=sr(t,this.array)),t}setY(e,t){return this.normalized&&(t=Rn(t,this.array)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=sr(t,this.array)),t}setZ(e,t){return this.normalized&&(t=Rn(t,this.array)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=sr(t,this.array)),t}setW(e,t){return this.normalized&&(t=Rn(t,this.array)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,n){return e*=this.itemSize,this.normalized&&(t=Rn(t,this.array),n=Rn(n,this.array)),this.array[e+0]=t,this.array[e+1]=n,this}setXYZ(e,t,n,s){return e*=this.itemSize,this.normalized&&(t=Rn(t,this.array),n=Rn(n,this.array),s=Rn(s,this.array)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this}setXYZW(e,t,n,s,o){return e*=this.itemSize,this.normalized&&(t=Rn(t,this.array),n=Rn(n,this.array),s=Rn(s,this.array),o=Rn(o,this.array)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this.array[e+3]=o,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){const e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return this.name!==""&&(e.name=this.name),this.usage!==Dd&&(e.usage=this.usage),e}}class ym extends Mi{constructor(e,t,n){super(new Uint16Array(e),t,n)}}class Mm extends Mi{constructor(e,t,n){super(new Uint32Array(e),t,n)}}class Si extends Mi{constructor(e,t,n){super(new Float32Array(e),t,n)}}let bC=0;const Wn=new zt,Vl=new dn,_o=new ee,kn=new Pr,lr=new Pr,cn=new ee;class gs extends Xo{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:bC++}),this.uuid=Rr(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={}}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(gm(e)?Mm:ym)(e,1):this.index=e,this}setIndirect(e){return this.indirect=e,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,n=0){this.groups.push({start:e,count:t,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){const t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);const n=this.attributes.normal;if(n!==void 0){const o=new tt().getNormalMatrix(e);n.applyNormalMatrix(o),n.needsUpdate=!0}const s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}applyQuaternion(e){return Wn.makeRotationFromQuaternion(e),this.applyMatrix4(Wn),this}rotateX(e){return Wn.makeRotationX(e),this.applyMatrix4(Wn),this}rotateY(e){return Wn.makeRotationY(e),this.applyMatrix4(Wn),this}rotateZ(e){return Wn.makeRotationZ(e),this.applyMatrix4(Wn),this}translate(e,t,n){return Wn.makeTranslation(e,t,n),this.applyMatrix4(Wn),this}scale(e,t,n){return Wn.makeScale(e,t,n),this.applyMatrix4(Wn),this}lookAt(e){return Vl.lookAt(e),Vl.updateMatrix(),this.applyMatrix4(Vl.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(_o).negate(),this.translate(_o.x,_o.y,_o.z),this}setFromPoints(e){const t=this.getAttribute("position");if(t===void 0){const n=[];for(let s=0,o=e.length;s<o;s++){const r=e[s];n.push(r.x,r.y,r.z||0)}this.setAttribute("position",new Si(n,3))}else{for(let n=0,s=t.count;n<s;n++){const o=e[n];t.setXYZ(n,o.x,o.y,o.z||0)}e.length>t.count&&console.warn("THREE.BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Pr);const e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){console.error("THREE.BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new ee(-1/0,-1/0,-1/0),new ee(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let n=0,s=t.length;n<s;n++){const o=t[n];kn.setFromBufferAttribute(o),this.morphTargetsRelative?(cn.addVectors(this.boundingBox.min,kn.min),this.boundingBox.expandByPoint(cn),cn.addVectors(this.boundingBox.max,kn.max),this.boundingBox.expandByPoint(cn)):(this.boundingBox.expandByPoint(kn.min),this.boundingBox.expandByPoint(kn.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&console.error('THREE.BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Fh);const e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){console.error("THREE.BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new ee,1/0);return}if(e){const n=this.boundingSphere.center;if(kn.setFromBufferAttribute(e),t)for(let o=0,r=t.length;o<r;o++){const a=t[o];lr.setFromBufferAttribute(a),this.morphTargetsRelative?(cn.addVectors(kn.min,lr.min),kn.expandByPoint(cn),cn.addVectors(kn.max,lr.max),kn.expandByPoint(cn)):(kn.expandByPoint(lr.min),kn.expandByPoint(lr.max))}kn.getCenter(n);let s=0;for(let o=0,r=e.count;o<r;o++)cn.fromBufferAttribute(e,o),s=Math.max(s,n.distanceToSquared(cn));if(t)for(let o=0,r=t.length;o<r;o++){const a=t[o],l=this.morphTargetsRelative;for(let c=0,h=a.count;c<h;c++)cn.fromBufferAttribute(a,c),l&&(_o.fromBufferAttribute(e,c),cn.add(_o)),s=Math.max(s,n.distanceToSquared(cn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&console.error('THREE.BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){const e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){console.error("THREE.BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}const n=t.position,s=t.normal,o=t.uv;this.hasAttribute("tangent")===!1&&this.setAttribute("tangent",new Mi(new Float32Array(4*n.count),4));const r=this.getAttribute("tangent"),a=[],l=[];for(let I=0;I<n.count;I++)a[I]=new ee,l[I]=new ee;const c=new ee,h=new ee,u=new ee,d=new vt,m=new vt,g=new vt,_=new ee,p=new ee;function f(I,E,y){c.fromBufferAttribute(n,I),h.fromBufferAttribute(n,E),u.fromBufferAttribute(n,y),d.fromBufferAttribute(o,I),m.fromBufferAttribute(o,E),g.fromBufferAttribute(o,y),h.sub(c),u.sub(c),m.sub(d),g.sub(d);const R=1/(m.x*g.y-g.x*m.y);isFinite(R)&&(_.copy(h).multiplyScalar(g.y).addScaledVector(u,-m.y).multiplyScalar(R),p.copy(u).multiplyScalar(m.x).addScaledVector(h,-g.x).multiplyScalar(R),a[I].add(_),a[E].add(_),a[y].add(_),l[I].add(p),l[E].add(p),l[y].add(p))}let M=this.groups;M.length===0&&(M=[{start:0,count:e.count}]);for(let I=0,E=M.length;I<E;++I){const y=M[I],R=y.start,V=y.count;for(let O=R,$=R+V;O<$;O+=3)f(e.getX(O+0),e.getX(O+1),e.getX(O+2))}const S=new ee,x=new ee,F=new ee,P=new ee;function A(I){F.fromBufferAttribute(s,I),P.copy(F);const E=a[I];S.copy(E),S.sub(F.multiplyScalar(F.dot(E))).normalize(),x.crossVectors(P,E);const R=x.dot(l[I])<0?-1:1;r.setXYZW(I,S.x,S.y,S.z,R)}for(let I=0,E=M.length;I<E;++I){const y=M[I],R=y.start,V=y.count;for(let O=R,$=R+V;O<$;O+=3)A(e.getX(O+0)),A(e.getX(O+1)),A(e.getX(O+2))}}computeVertexNormals(){const e=this.index,t=this.getAttribute("position");if(t!==void 0){let n=this.getAttribute("normal");if(n===void 0)n=new Mi(new Float32Array(t.count*3),3),this.setAttribute("normal",n);else for(let d=0,m=n.count;d<m;d++)n.setXYZ(d,0,0,0);const s=new ee,o=new ee,r=new ee,a=new ee,l=new ee,c=new ee,h=new ee,u=new ee;if(e)for(let d=0,m=e.count;d<m;d+=3){const g=e.getX(d+0),_=e.getX(d+1),p=e.getX(d+2);s.fromBufferAttribute(t,g),o.fromBufferAttribute(t,_),r.fromBufferAttribute(t,p),h.subVectors(r,o),u.subVectors(s,o),h.cross(u),a.fromBufferAttribute(n,g),l.fromBufferAttribute(n,_),c.fromBufferAttribute(n,p),a.add(h),l.add(h),c.add(h),n.setXYZ(g,a.x,a.y,a.z),n.setXYZ(_,l.x,l.y,l.z),n.setXYZ(p,c.x,c.y,c.z)}else for(let d=0,m=t.count;d<m;d+=3)s.fromBufferAttribute(t,d+0),o.fromBufferAttribute(t,d+1),r.fromBufferAttribute(t,d+2),h.subVectors(r,o),u.subVectors(s,o),h.cross(u),n.setXYZ(d+0,h.x,h.y,h.z),n.setXYZ(d+1,h.x,h.y,h.z),n.setXYZ(d+2,h.x,h.y,h.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){const e=this.attributes.normal;for(let t=0,n=e.count;t<n;t++)cn.fromBufferAttribute(e,t),cn.normalize(),e.setXYZ(t,cn.x,cn.y,cn.z)}toNonIndexed(){function e(a,l){const c=a.array,h=a.itemSize,u=a.normalized,d=new c.constructor(l.length*h);let m=0,g=0;for(let _=0,p=l.length;_<p;_++){a.isInterleavedBufferAttribute?m=l[_]*a.data.stride+a.offset:m=l[_]*h;for(let f=0;f<h;f++)d[g++]=c[m++]}return new Mi(d,h,u)}if(this.index===null)return console.warn("THREE.BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;const t=new gs,n=this.index.array,s=this.attributes;for(const a in s){const l=s[a],c=e(l,n);t.setAttribute(a,c)}const o=this.morphAttributes;for(const a in o){const l=[],c=o[a];for(let h=0,u=c.length;h<u;h++){const d=c[h],m=e(d,n);l.push(m)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;const r=this.groups;for(let a=0,l=r.length;a<l;a++){const c=r[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){const e={metadata:{version:4.6,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.type,this.name!==""&&(e.name=this.name),Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0){const l=this.parameters;for(const c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};const t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});const n=this.attributes;for(const l in n){const c=n[l];e.data.attributes[l]=c.toJSON(e.data)}const s={};let o=!1;for(const l in this.morphAttributes){const c=this.morphAttributes[l],h=[];for(let u=0,d=c.length;u<d;u++){const m=c[u];h.push(m.toJSON(e.data))}h.length>0&&(s[l]=h,o=!0)}o&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);const r=this.groups;r.length>0&&(e.data.groups=JSON.parse(JSON.stringify(r)));const a=this.boundingSphere;return a!==null&&(e.data.boundingSphere={center:a.center.toArray(),radius:a.radius}),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;const t={};this.name=e.name;const n=e.index;n!==null&&this.setIndex(n.clone(t));const s=e.attributes;for(const c in s){const h=s[c];this.setAttribute(c,h.clone(t))}const o=e.morphAttributes;for(const c in o){const h=[],u=o[c];for(let d=0,m=u.length;d<m;d++)h.push(u[d].clone(t));this.morphAttributes[c]=h}this.morphTargetsRelative=e.morphTargetsRelative;const r=e.groups;for(let c=0,h=r.length;c<h;c++){const u=r[c];this.addGroup(u.start,u.count,u.materialIndex)}const a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());const l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this}dispose(){this.dispatchEvent({type:"dispose"})}}const Kd=new zt,Es=new xm,ia=new Fh,Zd=new ee,sa=new ee,oa=new ee,ra=new ee,Gl=new ee,aa=new ee,Jd=new ee,la=new ee;class un extends dn{constructor(e=new gs,t=new Bh){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0&&(this.morphTargetInfluences=e.morphTargetInfluences.slice()),e.morphTargetDictionary!==void 0&&(this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary)),this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){const t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){const s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let o=0,r=s.length;o<r;o++){const a=s[o].name||String(o);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=o}}}}getVertexPosition(e,t){const n=this.geometry,s=n.attributes.position,o=n.morphAttributes.position,r=n.morphTargetsRelative;t.fromBufferAttribute(s,e);const a=this.morphTargetInfluences;if(o&&a){aa.set(0,0,0);for(let l=0,c=o.length;l<c;l++){const h=a[l],u=o[l];h!==0&&(Gl.fromBufferAttribute(u,e),r?aa.addScaledVector(Gl,h):aa.addScaledVector(Gl.sub(t),h))}t.add(aa)}return t}raycast(e,t){const n=this.geometry,s=this.material,o=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),ia.copy(n.boundingSphere),ia.applyMatrix4(o),Es.copy(e.ray).recast(e.near),!(ia.containsPoint(Es.origin)===!1&&(Es.intersectSphere(ia,Zd)===null||Es.origin.distanceToSquared(Zd)>(e.far-e.near)**2))&&(Kd.copy(o).invert(),Es.copy(e.ray).applyMatrix4(Kd),!(n.boundingBox!==null&&Es.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(e,t,Es)))}_computeIntersections(e,t,n){let s;const o=this.geometry,r=this.material,a=o.index,l=o.attributes.position,c=o.attributes.uv,h=o.attributes.uv1,u=o.attributes.normal,d=o.groups,m=o.drawRange;if(a!==null)if(Array.isArray(r))for(let g=0,_=d.length;g<_;g++){const p=d[g],f=r[p.materialIndex],M=Math.max(p.start,m.start),S=Math.min(a.count,Math.min(p.start+p.count,m.start+m.count));for(let x=M,F=S;x<F;x+=3){const P=a.getX(x),A=a.getX(x+1),I=a.getX(x+2);s=ca(this,f,e,n,c,h,u,P,A,I),s&&(s.faceIndex=Math.floor(x/3),s.face.materialIndex=p.materialIndex,t.push(s))}}else{const g=Math.max(0,m.start),_=Math.min(a.count,m.start+m.count);for(let p=g,f=_;p<f;p+=3){const M=a.getX(p),S=a.getX(p+1),x=a.getX(p+2);s=ca(this,r,e,n,c,h,u,M,S,x),s&&(s.faceIndex=Math.floor(p/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(r))for(let g=0,_=d.length;g<_;g++){const p=d[g],f=r[p.materialIndex],M=Math.max(p.start,m.start),S=Math.min(l.count,Math.min(p.start+p.count,m.start+m.count));for(let x=M,F=S;x<F;x+=3){const P=x,A=x+1,I=x+2;s=ca(this,f,e,n,c,h,u,P,A,I),s&&(s.faceIndex=Math.floor(x/3),s.face.materialIndex=p.materialIndex,t.push(s))}}else{const g=Math.max(0,m.start),_=Math.min(l.count,m.start+m.count);for(let p=g,f=_;p<f;p+=3){const M=p,S=p+1,x=p+2;s=ca(this,r,e,n,c,h,u,M,S,x),s&&(s.faceIndex=Math.floor(p/3),t.push(s))}}}}function yC(i,e,t,n,s,o,r,a){let l;if(e.side===Pn?l=n.intersectTriangle(r,o,s,!0,a):l=n.intersectTriangle(s,o,r,e.side===ps,a),l===null)return null;la.copy(a),la.applyMatrix4(i.matrixWorld);const c=t.ray.origin.distanceTo(la);return c<t.near||c>t.far?null:{distance:c,point:la.clone(),object:i}}function ca(i,e,t,n,s,o,r,a,l,c){i.getVertexPosition(a,sa),i.getVertexPosition(l,oa),i.getVertexPosition(c,ra);const h=yC(i,e,t,n,sa,oa,ra,Jd);if(h){const u=new ee;ai.getBarycoord(Jd,sa,oa,ra,u),s&&(h.uv=ai.getInterpolatedAttribute(s,a,l,c,u,new vt)),o&&(h.uv1=ai.getInterpolatedAttribute(o,a,l,c,u,new vt)),r&&(h.normal=ai.getInterpolatedAttribute(r,a,l,c,u,new ee),h.normal.dot(n.direction)>0&&h.normal.multiplyScalar(-1));const d={a,b:l,c,normal:new ee,materialIndex:0};ai.getNormal(sa,oa,ra,d.normal),h.face=d,h.barycoord=u}return h}class $s extends gs{constructor(e=1,t=1,n=1,s=1,o=1,r=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:n,widthSegments:s,heightSegments:o,depthSegments:r};const a=this;s=Math.floor(s),o=Math.floor(o),r=Math.floor(r);const l=[],c=[],h=[],u=[];let d=0,m=0;g("z","y","x",-1,-1,n,t,e,r,o,0),g("z","y","x",1,-1,n,t,-e,r,o,1),g("x","z","y",1,1,e,n,t,s,r,2),g("x","z","y",1,-1,e,n,-t,s,r,3),g("x","y","z",1,-1,e,t,n,s,o,4),g("x","y","z",-1,-1,e,t,-n,s,o,5),this.setIndex(l),this.setAttribute("position",new Si(c,3)),this.setAttribute("normal",new Si(h,3)),this.setAttribute("uv",new Si(u,2));function g(_,p,f,M,S,x,F,P,A,I,E){const y=x/A,R=F/I,V=x/2,O=F/2,$=P/2,q=A+1,X=I+1;let Y=0,te=0;const le=new ee;for(let he=0;he<X;he++){const _e=he*R-O;for(let Me=0;Me<q;Me++){const ge=Me*y-V;le[_]=ge*M,le[p]=_e*S,le[f]=$,c.push(le.x,le.y,le.z),le[_]=0,le[p]=0,le[f]=P>0?1:-1,h.push(le.x,le.y,le.z),u.push(Me/A),u.push(1-he/I),Y+=1}}for(let he=0;he<I;he++)for(let _e=0;_e<A;_e++){const Me=d+_e+q*he,ge=d+_e+q*(he+1),oe=d+(_e+1)+q*(he+1),ue=d+(_e+1)+q*he;l.push(Me,ge,ue),l.push(ge,oe,ue),te+=6}a.addGroup(m,te,E),m+=te,d+=Y}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new $s(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}}function zo(i){const e={};for(const t in i){e[t]={};for(const n in i[t]){const s=i[t][n];s&&(s.isColor||s.isMatrix3||s.isMatrix4||s.isVector2||s.isVector3||s.isVector4||s.isTexture||s.isQuaternion)?s.isRenderTargetTexture?(console.warn("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][n]=null):e[t][n]=s.clone():Array.isArray(s)?e[t][n]=s.slice():e[t][n]=s}}return e}function Mn(i){const e={};for(let t=0;t<i.length;t++){const n=zo(i[t]);for(const s in n)e[s]=n[s]}return e}function MC(i){const e=[];for(let t=0;t<i.length;t++)e.push(i[t].clone());return e}function Sm(i){const e=i.getRenderTarget();return e===null?i.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:gt.workingColorSpace}const SC={clone:zo,merge:Mn};var wC=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,EC=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`;class ms extends Lr{static get type(){return"ShaderMaterial"}constructor(e){super(),this.isShaderMaterial=!0,this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=wC,this.fragmentShader=EC,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=zo(e.uniforms),this.uniformsGroups=MC(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this}toJSON(e){const t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(const s in this.uniforms){const r=this.uniforms[s].value;r&&r.isTexture?t.uniforms[s]={type:"t",value:r.toJSON(e).uuid}:r&&r.isColor?t.uniforms[s]={type:"c",value:r.getHex()}:r&&r.isVector2?t.uniforms[s]={type:"v2",value:r.toArray()}:r&&r.isVector3?t.uniforms[s]={type:"v3",value:r.toArray()}:r&&r.isVector4?t.uniforms[s]={type:"v4",value:r.toArray()}:r&&r.isMatrix3?t.uniforms[s]={type:"m3",value:r.toArray()}:r&&r.isMatrix4?t.uniforms[s]={type:"m4",value:r.toArray()}:t.uniforms[s]={value:r}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;const n={};for(const s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(t.extensions=n),t}}class wm extends dn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new zt,this.projectionMatrix=new zt,this.projectionMatrixInverse=new zt,this.coordinateSystem=Bi}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorldInverse.copy(this.matrixWorld).invert()}updateWorldMatrix(e,t){super.updateWorldMatrix(e,t),this.matrixWorldInverse.copy(this.matrixWorld).invert()}clone(){return new this.constructor().copy(this)}}const ns=new ee,Qd=new vt,ef=new vt;class Yn extends wm{constructor(e=50,t=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){const t=.5*this.getFilmHeight()/e;this.fov=Qc*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){const e=Math.tan(Sl*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return Qc*2*Math.atan(Math.tan(Sl*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,n){ns.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(ns.x,ns.y).multiplyScalar(-e/ns.z),ns.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(ns.x,ns.y).multiplyScalar(-e/ns.z)}getViewSize(e,t){return this.getViewBounds(e,Qd,ef),t.subVectors(ef,Qd)}setViewOffset(e,t,n,s,o,r){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=o,this.view.height=r,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){const e=this.near;let t=e*Math.tan(Sl*.5*this.fov)/this.zoom,n=2*t,s=this.aspect*n,o=-.5*s;const r=this.view;if(this.view!==null&&this.view.enabled){const l=r.fullWidth,c=r.fullHeight;o+=r.offsetX*s/l,t-=r.offsetY*n/c,s*=r.width/l,n*=r.height/c}const a=this.filmOffset;a!==0&&(o+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(o,o+s,t,t-n,e,this.far,this.coordinateSystem),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){const t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}}const vo=-90,xo=1;class TC extends dn{constructor(e,t,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;const s=new Yn(vo,xo,e,t);s.layers=this.layers,this.add(s);const o=new Yn(vo,xo,e,t);o.layers=this.layers,this.add(o);const r=new Yn(vo,xo,e,t);r.layers=this.layers,this.add(r);const a=new Yn(vo,xo,e,t);a.layers=this.layers,this.add(a);const l=new Yn(vo,xo,e,t);l.layers=this.layers,this.add(l);const c=new Yn(vo,xo,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){const e=this.coordinateSystem,t=this.children.concat(),[n,s,o,r,a,l]=t;for(const c of t)this.remove(c);if(e===Bi)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),o.up.set(0,0,-1),o.lookAt(0,1,0),r.up.set(0,0,1),r.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===Ua)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),o.up.set(0,0,1),o.lookAt(0,1,0),r.up.set(0,0,-1),r.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(const c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();const{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());const[o,r,a,l,c,h]=this.children,u=e.getRenderTarget(),d=e.getActiveCubeFace(),m=e.getActiveMipmapLevel(),g=e.xr.enabled;e.xr.enabled=!1;const _=n.texture.generateMipmaps;n.texture.generateMipmaps=!1,e.setRenderTarget(n,0,s),e.render(t,o),e.setRenderTarget(n,1,s),e.render(t,r),e.setRenderTarget(n,2,s),e.render(t,a),e.setRenderTarget(n,3,s),e.render(t,l),e.setRenderTarget(n,4,s),e.render(t,c),n.texture.generateMipmaps=_,e.setRenderTarget(n,5,s),e.render(t,h),e.setRenderTarget(u,d,m),e.xr.enabled=g,n.texture.needsPMREMUpdate=!0}}class Em extends En{constructor(e,t,n,s,o,r,a,l,c,h){e=e!==void 0?e:[],t=t!==void 0?t:ko,super(e,t,n,s,o,r,a,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}}class AC extends Ws{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;const n={width:e,height:e,depth:1},s=[n,n,n,n,n,n];this.texture=new Em(s,t.mapping,t.wrapS,t.wrapT,t.magFilter,t.minFilter,t.format,t.type,t.anisotropy,t.colorSpace),this.texture.isRenderTargetTexture=!0,this.texture.generateMipmaps=t.generateMipmaps!==void 0?t.generateMipmaps:!1,this.texture.minFilter=t.minFilter!==void 0?t.minFilter:bi}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;const n={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new $s(5,5,5),o=new ms({name:"CubemapFromEquirect",uniforms:zo(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:Pn,blending:cs});o.uniforms.tEquirect.value=t;const r=new un(s,o),a=t.minFilter;return t.minFilter===Os&&(t.minFilter=bi),new TC(1,10,this).update(e,r),t.minFilter=a,r.geometry.dispose(),r.material.dispose(),this}clear(e,t,n,s){const o=e.getRenderTarget();for(let r=0;r<6;r++)e.setRenderTarget(this,r),e.clear(t,n,s);e.setRenderTarget(o)}}const Wl=new ee,RC=new ee,CC=new tt;class rs{constructor(e=new ee(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,n,s){return this.normal.set(e,t,n),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,n){const s=Wl.subVectors(n,t).cross(RC.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){const e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t){const n=e.delta(Wl),s=this.normal.dot(n);if(s===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;const o=-(e.start.dot(this.normal)+this.constant)/s;return o<0||o>1?null:t.copy(e.start).addScaledVector(n,o)}intersectsLine(e){const t=this.distanceToPoint(e.start),n=this.distanceToPoint(e.end);return t<0&&n>0||n<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){const n=t||CC.getNormalMatrix(e),s=this.coplanarPoint(Wl).applyMatrix4(e),o=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(o),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}}const Ts=new Fh,ha=new ee;class zh{constructor(e=new rs,t=new rs,n=new rs,s=new rs,o=new rs,r=new rs){this.planes=[e,t,n,s,o,r]}set(e,t,n,s,o,r){const a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(n),a[3].copy(s),a[4].copy(o),a[5].copy(r),this}copy(e){const t=this.planes;for(let n=0;n<6;n++)t[n].copy(e.planes[n]);return this}setFromProjectionMatrix(e,t=Bi){const n=this.planes,s=e.elements,o=s[0],r=s[1],a=s[2],l=s[3],c=s[4],h=s[5],u=s[6],d=s[7],m=s[8],g=s[9],_=s[10],p=s[11],f=s[12],M=s[13],S=s[14],x=s[15];if(n[0].setComponents(l-o,d-c,p-m,x-f).normalize(),n[1].setComponents(l+o,d+c,p+m,x+f).normalize(),n[2].setComponents(l+r,d+h,p+g,x+M).normalize(),n[3].setComponents(l-r,d-h,p-g,x-M).normalize(),n[4].setComponents(l-a,d-u,p-_,x-S).normalize(),t===Bi)n[5].setComponents(l+a,d+u,p+_,x+S).normalize();else if(t===Ua)n[5].setComponents(a,u,_,S).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),Ts.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{const t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),Ts.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(Ts)}intersectsSprite(e){return Ts.center.set(0,0,0),Ts.radius=.7071067811865476,Ts.applyMatrix4(e.matrixWorld),this.intersectsSphere(Ts)}intersectsSphere(e){const t=this.planes,n=e.center,s=-e.radius;for(let o=0;o<6;o++)if(t[o].distanceToPoint(n)<s)return!1;return!0}intersectsBox(e){const t=this.planes;for(let n=0;n<6;n++){const s=t[n];if(ha.x=s.normal.x>0?e.max.x:e.min.x,ha.y=s.normal.y>0?e.max.y:e.min.y,ha.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(ha)<0)return!1}return!0}containsPoint(e){const t=this.planes;for(let n=0;n<6;n++)if(t[n].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}}function Tm(){let i=null,e=!1,t=null,n=null;function s(o,r){t(o,r),n=i.requestAnimationFrame(s)}return{start:function(){e!==!0&&t!==null&&(n=i.requestAnimationFrame(s),e=!0)},stop:function(){i.cancelAnimationFrame(n),e=!1},setAnimationLoop:function(o){t=o},setContext:function(o){i=o}}}function PC(i){const e=new WeakMap;function t(a,l){const c=a.array,h=a.usage,u=c.byteLength,d=i.createBuffer();i.bindBuffer(l,d),i.bufferData(l,c,h),a.onUploadCallback();let m;if(c instanceof Float32Array)m=i.FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?m=i.HALF_FLOAT:m=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)m=i.SHORT;else if(c instanceof Uint32Array)m=i.UNSIGNED_INT;else if(c instanceof Int32Array)m=i.INT;else if(c instanceof Int8Array)m=i.BYTE;else if(c instanceof Uint8Array)m=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)m=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:d,type:m,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:u}}function n(a,l,c){const h=l.array,u=l.updateRanges;if(i.bindBuffer(c,a),u.length===0)i.bufferSubData(c,0,h);else{u.sort((m,g)=>m.start-g.start);let d=0;for(let m=1;m<u.length;m++){const g=u[d],_=u[m];_.start<=g.start+g.count+1?g.count=Math.max(g.count,_.start+_.count-g.start):(++d,u[d]=_)}u.length=d+1;for(let m=0,g=u.length;m<g;m++){const _=u[m];i.bufferSubData(c,_.start*h.BYTES_PER_ELEMENT,h,_.start,_.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function o(a){a.isInterleavedBufferAttribute&&(a=a.data);const l=e.get(a);l&&(i.deleteBuffer(l.buffer),e.delete(a))}function r(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){const h=e.get(a);(!h||h.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}const c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,a,l),c.version=a.version}}return{get:s,remove:o,update:r}}class Nr extends gs{constructor(e=1,t=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:n,heightSegments:s};const o=e/2,r=t/2,a=Math.floor(n),l=Math.floor(s),c=a+1,h=l+1,u=e/a,d=t/l,m=[],g=[],_=[],p=[];for(let f=0;f<h;f++){const M=f*d-r;for(let S=0;S<c;S++){const x=S*u-o;g.push(x,-M,0),_.push(0,0,1),p.push(S/a),p.push(1-f/l)}}for(let f=0;f<l;f++)for(let M=0;M<a;M++){const S=M+c*f,x=M+c*(f+1),F=M+1+c*(f+1),P=M+1+c*f;m.push(S,x,P),m.push(x,F,P)}this.setIndex(m),this.setAttribute("position",new Si(g,3)),this.setAttribute("normal",new Si(_,3)),this.setAttribute("uv",new Si(p,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new Nr(e.width,e.height,e.widthSegments,e.heightSegments)}}var LC=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,NC=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,DC=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,IC=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,UC=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,kC=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,FC=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,OC=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,BC=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec3 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 ).rgb;
	}
#endif`,zC=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,HC=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,VC=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,GC=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,WC=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,$C=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,qC=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,XC=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,jC=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,YC=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,KC=`#if defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#elif defined( USE_COLOR )
	diffuseColor.rgb *= vColor;
#endif`,ZC=`#if defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#elif defined( USE_COLOR )
	varying vec3 vColor;
#endif`,JC=`#if defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#elif defined( USE_COLOR ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec3 vColor;
#endif`,QC=`#if defined( USE_COLOR_ALPHA )
	vColor = vec4( 1.0 );
#elif defined( USE_COLOR ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec3( 1.0 );
#endif
#ifdef USE_COLOR
	vColor *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.xyz *= instanceColor.xyz;
#endif
#ifdef USE_BATCHING_COLOR
	vec3 batchingColor = getBatchingColor( getIndirectIndex( gl_DrawID ) );
	vColor.xyz *= batchingColor.xyz;
#endif`,e2=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
vec3 inverseTransformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( vec4( dir, 0.0 ) * matrix ).xyz );
}
mat3 transposeMat3( const in mat3 m ) {
	mat3 tmp;
	tmp[ 0 ] = vec3( m[ 0 ].x, m[ 1 ].x, m[ 2 ].x );
	tmp[ 1 ] = vec3( m[ 0 ].y, m[ 1 ].y, m[ 2 ].y );
	tmp[ 2 ] = vec3( m[ 0 ].z, m[ 1 ].z, m[ 2 ].z );
	return tmp;
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,t2=`#ifdef ENVMAP_TYPE_CUBE_UV
	#define cubeUV_minMipLevel 4.0
	#define cubeUV_minTileSize 16.0
	float getFace( vec3 direction ) {
		vec3 absDirection = abs( direction );
		float face = - 1.0;
		if ( absDirection.x > absDirection.z ) {
			if ( absDirection.x > absDirection.y )
				face = direction.x > 0.0 ? 0.0 : 3.0;
			else
				face = direction.y > 0.0 ? 1.0 : 4.0;
		} else {
			if ( absDirection.z > absDirection.y )
				face = direction.z > 0.0 ? 2.0 : 5.0;
			else
				face = direction.y > 0.0 ? 1.0 : 4.0;
		}
		return face;
	}
	vec2 getUV( vec3 direction, float face ) {
		vec2 uv;
		if ( face == 0.0 ) {
			uv = vec2( direction.z, direction.y ) / abs( direction.x );
		} else if ( face == 1.0 ) {
			uv = vec2( - direction.x, - direction.z ) / abs( direction.y );
		} else if ( face == 2.0 ) {
			uv = vec2( - direction.x, direction.y ) / abs( direction.z );
		} else if ( face == 3.0 ) {
			uv = vec2( - direction.z, direction.y ) / abs( direction.x );
		} else if ( face == 4.0 ) {
			uv = vec2( - direction.x, direction.z ) / abs( direction.y );
		} else {
			uv = vec2( direction.x, direction.y ) / abs( direction.z );
		}
		return 0.5 * ( uv + 1.0 );
	}
	vec3 bilinearCubeUV( sampler2D envMap, vec3 direction, float mipInt ) {
		float face = getFace( direction );
		float filterInt = max( cubeUV_minMipLevel - mipInt, 0.0 );
		mipInt = max( mipInt, cubeUV_minMipLevel );
		float faceSize = exp2( mipInt );
		highp vec2 uv = getUV( direction, face ) * ( faceSize - 2.0 ) + 1.0;
		if ( face > 2.0 ) {
			uv.y += faceSize;
			face -= 3.0;
		}
		uv.x += face * faceSize;
		uv.x += filterInt * 3.0 * cubeUV_minTileSize;
		uv.y += 4.0 * ( exp2( CUBEUV_MAX_MIP ) - faceSize );
		uv.x *= CUBEUV_TEXEL_WIDTH;
		uv.y *= CUBEUV_TEXEL_HEIGHT;
		#ifdef texture2DGradEXT
			return texture2DGradEXT( envMap, uv, vec2( 0.0 ), vec2( 0.0 ) ).rgb;
		#else
			return texture2D( envMap, uv ).rgb;
		#endif
	}
	#define cubeUV_r0 1.0
	#define cubeUV_m0 - 2.0
	#define cubeUV_r1 0.8
	#define cubeUV_m1 - 1.0
	#define cubeUV_r4 0.4
	#define cubeUV_m4 2.0
	#define cubeUV_r5 0.305
	#define cubeUV_m5 3.0
	#define cubeUV_r6 0.21
	#define cubeUV_m6 4.0
	float roughnessToMip( float roughness ) {
		float mip = 0.0;
		if ( roughness >= cubeUV_r1 ) {
			mip = ( cubeUV_r0 - roughness ) * ( cubeUV_m1 - cubeUV_m0 ) / ( cubeUV_r0 - cubeUV_r1 ) + cubeUV_m0;
		} else if ( roughness >= cubeUV_r4 ) {
			mip = ( cubeUV_r1 - roughness ) * ( cubeUV_m4 - cubeUV_m1 ) / ( cubeUV_r1 - cubeUV_r4 ) + cubeUV_m1;
		} else if ( roughness >= cubeUV_r5 ) {
			mip = ( cubeUV_r4 - roughness ) * ( cubeUV_m5 - cubeUV_m4 ) / ( cubeUV_r4 - cubeUV_r5 ) + cubeUV_m4;
		} else if ( roughness >= cubeUV_r6 ) {
			mip = ( cubeUV_r5 - roughness ) * ( cubeUV_m6 - cubeUV_m5 ) / ( cubeUV_r5 - cubeUV_r6 ) + cubeUV_m5;
		} else {
			mip = - 2.0 * log2( 1.16 * roughness );		}
		return mip;
	}
	vec4 textureCubeUV( sampler2D envMap, vec3 sampleDir, float roughness ) {
		float mip = clamp( roughnessToMip( roughness ), cubeUV_m0, CUBEUV_MAX_MIP );
		float mipF = fract( mip );
		float mipInt = floor( mip );
		vec3 color0 = bilinearCubeUV( envMap, sampleDir, mipInt );
		if ( mipF == 0.0 ) {
			return vec4( color0, 1.0 );
		} else {
			vec3 color1 = bilinearCubeUV( envMap, sampleDir, mipInt + 1.0 );
			return vec4( mix( color0, color1, mipF ), 1.0 );
		}
	}
#endif`,n2=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
	#ifdef FLIP_SIDED
		transformedTangent = - transformedTangent;
	#endif
#endif`,i2=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,s2=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,o2=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,r2=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,a2="gl_FragColor = linearToOutputTexel( gl_FragColor );",l2=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,c2=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = inverseTransformDirection( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * vec3( flipEnvMap * reflectVec.x, reflectVec.yz ) );
	#else
		vec4 envColor = vec4( 0.0 );
	#endif
	#ifdef ENVMAP_BLENDING_MULTIPLY
		outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
	#elif defined( ENVMAP_BLENDING_MIX )
		outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
	#elif defined( ENVMAP_BLENDING_ADD )
		outgoingLight += envColor.xyz * specularStrength * reflectivity;
	#endif
#endif`,h2=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform float flipEnvMap;
	uniform mat3 envMapRotation;
	#ifdef ENVMAP_TYPE_CUBE
		uniform samplerCube envMap;
	#else
		uniform sampler2D envMap;
	#endif
	
#endif`,u2=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,d2=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,f2=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = inverseTransformDirection( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,p2=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,m2=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,g2=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,_2=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,v2=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,x2=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,b2=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,y2=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,M2=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = inverseTransformDirection( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif`,S2=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_CUBE_UV
			vec3 worldNormal = inverseTransformDirection( normal, viewMatrix );
			vec4 envMapColor = textureCubeUV( envMap, envMapRotation * worldNormal, 1.0 );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_CUBE_UV
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, roughness * roughness) );
			reflectVec = inverseTransformDirection( reflectVec, viewMatrix );
			vec4 envMapColor = textureCubeUV( envMap, envMapRotation * reflectVec, roughness );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_CUBE_UV
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
#endif`,w2=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,E2=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,T2=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,A2=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,R2=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb * ( 1.0 - metalnessFactor );
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.0525 );material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = mix( min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = mix( vec3( 0.04 ), diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.0525 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.07, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,C2=`struct PhysicalMaterial {
	vec3 diffuseColor;
	float roughness;
	vec3 specularColor;
	float specularF90;
	float dispersion;
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		float v = 0.5 / ( gv + gl );
		return saturate(v);
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = material.clearcoatRoughness;
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColor;
	float f90 = material.specularF90;
	float roughness = material.roughness;
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float V = V_GGX_SmithCorrelated_Anisotropic( material.alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( material.alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transposeMat3( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float a = roughness < 0.25 ? -339.2 * r2 + 161.4 * roughness - 25.9 : -8.48 * r2 + 14.3 * roughness - 9.95;
	float b = roughness < 0.25 ? 44.0 * r2 - 23.7 * roughness + 3.26 : 1.97 * r2 - 3.27 * roughness + 0.72;
	float DG = exp( a * dotNV + b ) + ( roughness < 0.25 ? 0.0 : 0.1 * ( roughness - 0.25 ) );
	return saturate( DG * RECIPROCAL_PI );
}
vec2 DFGApprox( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	const vec4 c0 = vec4( - 1, - 0.0275, - 0.572, 0.022 );
	const vec4 c1 = vec4( 1, 0.0425, 1.04, - 0.04 );
	vec4 r = roughness * c0 + c1;
	float a004 = min( r.x * r.x, exp2( - 9.28 * dotNV ) ) * r.x + r.y;
	vec2 fab = vec2( - 1.04, 1.04 ) * a004 + r.zw;
	return fab;
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	vec2 fab = DFGApprox( normal, viewDir, roughness );
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, const in float roughness, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	vec2 fab = DFGApprox( normal, viewDir, roughness );
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColor * t2.x + ( vec3( 1.0 ) - material.specularColor ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseColor * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
	#endif
	reflectedLight.directSpecular += irradiance * BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
	#endif
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( geometryNormal, geometryViewDir, material.specularColor, material.specularF90, material.iridescence, material.iridescenceFresnel, material.roughness, singleScattering, multiScattering );
	#else
		computeMultiscattering( geometryNormal, geometryViewDir, material.specularColor, material.specularF90, material.roughness, singleScattering, multiScattering );
	#endif
	vec3 totalScattering = singleScattering + multiScattering;
	vec3 diffuse = material.diffuseColor * ( 1.0 - max( max( totalScattering.r, totalScattering.g ), totalScattering.b ) );
	reflectedLight.indirectSpecular += radiance * singleScattering;
	reflectedLight.indirectSpecular += multiScattering * cosineWeightedIrradiance;
	reflectedLight.indirectDiffuse += diffuse * cosineWeightedIrradiance;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,P2=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		material.iridescenceFresnel = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		material.iridescenceF0 = Schlick_to_F0( material.iridescenceFresnel, 1.0, dotNVi );
	}
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,L2=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD ) && defined( ENVMAP_TYPE_CUBE_UV )
		iblIrradiance += getIBLIrradiance( geometryNormal );
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		radiance += getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		radiance += getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,N2=`#if defined( RE_IndirectDiffuse )
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,D2=`#if defined( USE_LOGDEPTHBUF )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,I2=`#if defined( USE_LOGDEPTHBUF )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,U2=`#ifdef USE_LOGDEPTHBUF
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,k2=`#ifdef USE_LOGDEPTHBUF
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,F2=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,O2=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,B2=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,z2=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,H2=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,V2=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,G2=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,W2=`#if defined( USE_MORPHCOLORS )
	vColor *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,$2=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,q2=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,X2=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,j2=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#if defined( DOUBLE_SIDED ) && ! defined( FLAT_SHADED )
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#if defined( DOUBLE_SIDED ) && ! defined( FLAT_SHADED )
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,Y2=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,K2=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Z2=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,J2=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
	#endif
#endif`,Q2=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,eP=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,tP=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,nP=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,iP=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,sP=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,oP=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	return depth * ( near - far ) - near;
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	return ( near * far ) / ( ( far - near ) * depth - far );
}`,rP=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,aP=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,lP=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,cP=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,hP=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,uP=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,dP=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform sampler2D pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	float texture2DCompare( sampler2D depths, vec2 uv, float compare ) {
		return step( compare, unpackRGBAToDepth( texture2D( depths, uv ) ) );
	}
	vec2 texture2DDistribution( sampler2D shadow, vec2 uv ) {
		return unpackRGBATo2Half( texture2D( shadow, uv ) );
	}
	float VSMShadow (sampler2D shadow, vec2 uv, float compare ){
		float occlusion = 1.0;
		vec2 distribution = texture2DDistribution( shadow, uv );
		float hard_shadow = step( compare , distribution.x );
		if (hard_shadow != 1.0 ) {
			float distance = compare - distribution.x ;
			float variance = max( 0.00000, distribution.y * distribution.y );
			float softness_probability = variance / (variance + distance * distance );			softness_probability = clamp( ( softness_probability - 0.3 ) / ( 0.95 - 0.3 ), 0.0, 1.0 );			occlusion = clamp( max( hard_shadow, softness_probability ), 0.0, 1.0 );
		}
		return occlusion;
	}
	float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
		float shadow = 1.0;
		shadowCoord.xyz /= shadowCoord.w;
		shadowCoord.z += shadowBias;
		bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
		bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
		if ( frustumTest ) {
		#if defined( SHADOWMAP_TYPE_PCF )
			vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
			float dx0 = - texelSize.x * shadowRadius;
			float dy0 = - texelSize.y * shadowRadius;
			float dx1 = + texelSize.x * shadowRadius;
			float dy1 = + texelSize.y * shadowRadius;
			float dx2 = dx0 / 2.0;
			float dy2 = dy0 / 2.0;
			float dx3 = dx1 / 2.0;
			float dy3 = dy1 / 2.0;
			shadow = (
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx0, dy0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx1, dy0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx2, dy2 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy2 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx3, dy2 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx0, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx2, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy, shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx3, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx1, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx2, dy3 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy3 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx3, dy3 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx0, dy1 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy1 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx1, dy1 ), shadowCoord.z )
			) * ( 1.0 / 17.0 );
		#elif defined( SHADOWMAP_TYPE_PCF_SOFT )
			vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
			float dx = texelSize.x;
			float dy = texelSize.y;
			vec2 uv = shadowCoord.xy;
			vec2 f = fract( uv * shadowMapSize + 0.5 );
			uv -= f * texelSize;
			shadow = (
				texture2DCompare( shadowMap, uv, shadowCoord.z ) +
				texture2DCompare( shadowMap, uv + vec2( dx, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, uv + vec2( 0.0, dy ), shadowCoord.z ) +
				texture2DCompare( shadowMap, uv + texelSize, shadowCoord.z ) +
				mix( texture2DCompare( shadowMap, uv + vec2( -dx, 0.0 ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, 0.0 ), shadowCoord.z ),
					 f.x ) +
				mix( texture2DCompare( shadowMap, uv + vec2( -dx, dy ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, dy ), shadowCoord.z ),
					 f.x ) +
				mix( texture2DCompare( shadowMap, uv + vec2( 0.0, -dy ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( 0.0, 2.0 * dy ), shadowCoord.z ),
					 f.y ) +
				mix( texture2DCompare( shadowMap, uv + vec2( dx, -dy ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( dx, 2.0 * dy ), shadowCoord.z ),
					 f.y ) +
				mix( mix( texture2DCompare( shadowMap, uv + vec2( -dx, -dy ), shadowCoord.z ),
						  texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, -dy ), shadowCoord.z ),
						  f.x ),
					 mix( texture2DCompare( shadowMap, uv + vec2( -dx, 2.0 * dy ), shadowCoord.z ),
						  texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, 2.0 * dy ), shadowCoord.z ),
						  f.x ),
					 f.y )
			) * ( 1.0 / 9.0 );
		#elif defined( SHADOWMAP_TYPE_VSM )
			shadow = VSMShadow( shadowMap, shadowCoord.xy, shadowCoord.z );
		#else
			shadow = texture2DCompare( shadowMap, shadowCoord.xy, shadowCoord.z );
		#endif
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	vec2 cubeToUV( vec3 v, float texelSizeY ) {
		vec3 absV = abs( v );
		float scaleToCube = 1.0 / max( absV.x, max( absV.y, absV.z ) );
		absV *= scaleToCube;
		v *= scaleToCube * ( 1.0 - 2.0 * texelSizeY );
		vec2 planar = v.xy;
		float almostATexel = 1.5 * texelSizeY;
		float almostOne = 1.0 - almostATexel;
		if ( absV.z >= almostOne ) {
			if ( v.z > 0.0 )
				planar.x = 4.0 - v.x;
		} else if ( absV.x >= almostOne ) {
			float signX = sign( v.x );
			planar.x = v.z * signX + 2.0 * signX;
		} else if ( absV.y >= almostOne ) {
			float signY = sign( v.y );
			planar.x = v.x + 2.0 * signY + 2.0;
			planar.y = v.z * signY - 2.0;
		}
		return vec2( 0.125, 0.25 ) * planar + vec2( 0.375, 0.75 );
	}
	float getPointShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		
		float lightToPositionLength = length( lightToPosition );
		if ( lightToPositionLength - shadowCameraFar <= 0.0 && lightToPositionLength - shadowCameraNear >= 0.0 ) {
			float dp = ( lightToPositionLength - shadowCameraNear ) / ( shadowCameraFar - shadowCameraNear );			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			vec2 texelSize = vec2( 1.0 ) / ( shadowMapSize * vec2( 4.0, 2.0 ) );
			#if defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_PCF_SOFT ) || defined( SHADOWMAP_TYPE_VSM )
				vec2 offset = vec2( - 1, 1 ) * shadowRadius * texelSize.y;
				shadow = (
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xyy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yyy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xyx, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yyx, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xxy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yxy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xxx, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yxx, texelSize.y ), dp )
				) * ( 1.0 / 9.0 );
			#else
				shadow = texture2DCompare( shadowMap, cubeToUV( bd3D, texelSize.y ), dp );
			#endif
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
#endif`,fP=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,pP=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	vec3 shadowWorldNormal = inverseTransformDirection( transformedNormal, viewMatrix );
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,mP=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,gP=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,_P=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,vP=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,xP=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,bP=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,yP=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,MP=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,SP=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,wP=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = inverseTransformDirection( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseColor, material.specularColor, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,EP=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
		
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
		
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		
		#else
		
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,TP=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,AP=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,RP=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,CP=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`;const PP=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,LP=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,NP=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,DP=`#ifdef ENVMAP_TYPE_CUBE
	uniform samplerCube envMap;
#elif defined( ENVMAP_TYPE_CUBE_UV )
	uniform sampler2D envMap;
#endif
uniform float flipEnvMap;
uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <cube_uv_reflection_fragment>
void main() {
	#ifdef ENVMAP_TYPE_CUBE
		vec4 texColor = textureCube( envMap, backgroundRotation * vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) );
	#elif defined( ENVMAP_TYPE_CUBE_UV )
		vec4 texColor = textureCubeUV( envMap, backgroundRotation * vWorldDirection, backgroundBlurriness );
	#else
		vec4 texColor = vec4( 0.0, 0.0, 0.0, 1.0 );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,IP=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,UP=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,kP=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,FP=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	float fragCoordZ = 0.5 * vHighPrecisionZW[0] / vHighPrecisionZW[1] + 0.5;
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,OP=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,BP=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main () {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = packDepthToRGBA( dist );
}`,zP=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,HP=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,VP=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,GP=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,WP=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,$P=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,qP=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,XP=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <packing>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,jP=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,YP=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,KP=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,ZP=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <packing>
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( packNormalToRGB( normal ), diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,JP=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,QP=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <packing>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,eL=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,tL=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <packing>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <cube_uv_reflection_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
		float sheenEnergyComp = 1.0 - 0.157 * max3( material.sheenColor );
		outgoingLight = outgoingLight * sheenEnergyComp + sheenSpecularDirect + sheenSpecularIndirect;
	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,nL=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,iL=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <packing>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,sL=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,oL=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,rL=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,aL=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <packing>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,lL=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,cL=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,it={alphahash_fragment:LC,alphahash_pars_fragment:NC,alphamap_fragment:DC,alphamap_pars_fragment:IC,alphatest_fragment:UC,alphatest_pars_fragment:kC,aomap_fragment:FC,aomap_pars_fragment:OC,batching_pars_vertex:BC,batching_vertex:zC,begin_vertex:HC,beginnormal_vertex:VC,bsdfs:GC,iridescence_fragment:WC,bumpmap_pars_fragment:$C,clipping_planes_fragment:qC,clipping_planes_pars_fragment:XC,clipping_planes_pars_vertex:jC,clipping_planes_vertex:YC,color_fragment:KC,color_pars_fragment:ZC,color_pars_vertex:JC,color_vertex:QC,common:e2,cube_uv_reflection_fragment:t2,defaultnormal_vertex:n2,displacementmap_pars_vertex:i2,displacementmap_vertex:s2,emissivemap_fragment:o2,emissivemap_pars_fragment:r2,colorspace_fragment:a2,colorspace_pars_fragment:l2,envmap_fragment:c2,envmap_common_pars_fragment:h2,envmap_pars_fragment:u2,envmap_pars_vertex:d2,envmap_physical_pars_fragment:S2,envmap_vertex:f2,fog_vertex:p2,fog_pars_vertex:m2,fog_fragment:g2,fog_pars_fragment:_2,gradientmap_pars_fragment:v2,lightmap_pars_fragment:x2,lights_lambert_fragment:b2,lights_lambert_pars_fragment:y2,lights_pars_begin:M2,lights_toon_fragment:w2,lights_toon_pars_fragment:E2,lights_phong_fragment:T2,lights_phong_pars_fragment:A2,lights_physical_fragment:R2,lights_physical_pars_fragment:C2,lights_fragment_begin:P2,lights_fragment_maps:L2,lights_fragment_end:N2,logdepthbuf_fragment:D2,logdepthbuf_pars_fragment:I2,logdepthbuf_pars_vertex:U2,logdepthbuf_vertex:k2,map_fragment:F2,map_pars_fragment:O2,map_particle_fragment:B2,map_particle_pars_fragment:z2,metalnessmap_fragment:H2,metalnessmap_pars_fragment:V2,morphinstance_vertex:G2,morphcolor_vertex:W2,morphnormal_vertex:$2,morphtarget_pars_vertex:q2,morphtarget_vertex:X2,normal_fragment_begin:j2,normal_fragment_maps:Y2,normal_pars_fragment:K2,normal_pars_vertex:Z2,normal_vertex:J2,normalmap_pars_fragment:Q2,clearcoat_normal_fragment_begin:eP,clearcoat_normal_fragment_maps:tP,clearcoat_pars_fragment:nP,iridescence_pars_fragment:iP,opaque_fragment:sP,packing:oP,premultiplied_alpha_fragment:rP,project_vertex:aP,dithering_fragment:lP,dithering_pars_fragment:cP,roughnessmap_fragment:hP,roughnessmap_pars_fragment:uP,shadowmap_pars_fragment:dP,shadowmap_pars_vertex:fP,shadowmap_vertex:pP,shadowmask_pars_fragment:mP,skinbase_vertex:gP,skinning_pars_vertex:_P,skinning_vertex:vP,skinnormal_vertex:xP,specularmap_fragment:bP,specularmap_pars_fragment:yP,tonemapping_fragment:MP,tonemapping_pars_fragment:SP,transmission_fragment:wP,transmission_pars_fragment:EP,uv_pars_fragment:TP,uv_pars_vertex:AP,uv_vertex:RP,worldpos_vertex:CP,background_vert:PP,background_frag:LP,backgroundCube_vert:NP,backgroundCube_frag:DP,cube_vert:IP,cube_frag:UP,depth_vert:kP,depth_frag:FP,distanceRGBA_vert:OP,distanceRGBA_frag:BP,equirect_vert:zP,equirect_frag:HP,linedashed_vert:VP,linedashed_frag:GP,meshbasic_vert:WP,meshbasic_frag:$P,meshlambert_vert:qP,meshlambert_frag:XP,meshmatcap_vert:jP,meshmatcap_frag:YP,meshnormal_vert:KP,meshnormal_frag:ZP,meshphong_vert:JP,meshphong_frag:QP,meshphysical_vert:eL,meshphysical_frag:tL,meshtoon_vert:nL,meshtoon_frag:iL,points_vert:sL,points_frag:oL,shadow_vert:rL,shadow_frag:aL,sprite_vert:lL,sprite_frag:cL},Te={common:{diffuse:{value:new dt(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new tt},alphaMap:{value:null},alphaMapTransform:{value:new tt},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new tt}},envmap:{envMap:{value:null},envMapRotation:{value:new tt},flipEnvMap:{value:-1},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new tt}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new tt}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new tt},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new tt},normalScale:{value:new vt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new tt},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new tt}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new tt}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new tt}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new dt(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMap:{value:[]},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotShadowMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMap:{value:[]},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null}},points:{diffuse:{value:new dt(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new tt},alphaTest:{value:0},uvTransform:{value:new tt}},sprite:{diffuse:{value:new dt(16777215)},opacity:{value:1},center:{value:new vt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new tt},alphaMap:{value:null},alphaMapTransform:{value:new tt},alphaTest:{value:0}}},vi={basic:{uniforms:Mn([Te.common,Te.specularmap,Te.envmap,Te.aomap,Te.lightmap,Te.fog]),vertexShader:it.meshbasic_vert,fragmentShader:it.meshbasic_frag},lambert:{uniforms:Mn([Te.common,Te.specularmap,Te.envmap,Te.aomap,Te.lightmap,Te.emissivemap,Te.bumpmap,Te.normalmap,Te.displacementmap,Te.fog,Te.lights,{emissive:{value:new dt(0)}}]),vertexShader:it.meshlambert_vert,fragmentShader:it.meshlambert_frag},phong:{uniforms:Mn([Te.common,Te.specularmap,Te.envmap,Te.aomap,Te.lightmap,Te.emissivemap,Te.bumpmap,Te.normalmap,Te.displacementmap,Te.fog,Te.lights,{emissive:{value:new dt(0)},specular:{value:new dt(1118481)},shininess:{value:30}}]),vertexShader:it.meshphong_vert,fragmentShader:it.meshphong_frag},standard:{uniforms:Mn([Te.common,Te.envmap,Te.aomap,Te.lightmap,Te.emissivemap,Te.bumpmap,Te.normalmap,Te.displacementmap,Te.roughnessmap,Te.metalnessmap,Te.fog,Te.lights,{emissive:{value:new dt(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:it.meshphysical_vert,fragmentShader:it.meshphysical_frag},toon:{uniforms:Mn([Te.common,Te.aomap,Te.lightmap,Te.emissivemap,Te.bumpmap,Te.normalmap,Te.displacementmap,Te.gradientmap,Te.fog,Te.lights,{emissive:{value:new dt(0)}}]),vertexShader:it.meshtoon_vert,fragmentShader:it.meshtoon_frag},matcap:{uniforms:Mn([Te.common,Te.bumpmap,Te.normalmap,Te.displacementmap,Te.fog,{matcap:{value:null}}]),vertexShader:it.meshmatcap_vert,fragmentShader:it.meshmatcap_frag},points:{uniforms:Mn([Te.points,Te.fog]),vertexShader:it.points_vert,fragmentShader:it.points_frag},dashed:{uniforms:Mn([Te.common,Te.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:it.linedashed_vert,fragmentShader:it.linedashed_frag},depth:{uniforms:Mn([Te.common,Te.displacementmap]),vertexShader:it.depth_vert,fragmentShader:it.depth_frag},normal:{uniforms:Mn([Te.common,Te.bumpmap,Te.normalmap,Te.displacementmap,{opacity:{value:1}}]),vertexShader:it.meshnormal_vert,fragmentShader:it.meshnormal_frag},sprite:{uniforms:Mn([Te.sprite,Te.fog]),vertexShader:it.sprite_vert,fragmentShader:it.sprite_frag},background:{uniforms:{uvTransform:{value:new tt},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:it.background_vert,fragmentShader:it.background_frag},backgroundCube:{uniforms:{envMap:{value:null},flipEnvMap:{value:-1},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new tt}},vertexShader:it.backgroundCube_vert,fragmentShader:it.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:it.cube_vert,fragmentShader:it.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:it.equirect_vert,fragmentShader:it.equirect_frag},distanceRGBA:{uniforms:Mn([Te.common,Te.displacementmap,{referencePosition:{value:new ee},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:it.distanceRGBA_vert,fragmentShader:it.distanceRGBA_frag},shadow:{uniforms:Mn([Te.lights,Te.fog,{color:{value:new dt(0)},opacity:{value:1}}]),vertexShader:it.shadow_vert,fragmentShader:it.shadow_frag}};vi.physical={uniforms:Mn([vi.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new tt},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new tt},clearcoatNormalScale:{value:new vt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new tt},dispersion:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new tt},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new tt},sheen:{value:0},sheenColor:{value:new dt(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new tt},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new tt},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new tt},transmissionSamplerSize:{value:new vt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new tt},attenuationDistance:{value:0},attenuationColor:{value:new dt(0)},specularColor:{value:new dt(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new tt},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new tt},anisotropyVector:{value:new vt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new tt}}]),vertexShader:it.meshphysical_vert,fragmentShader:it.meshphysical_frag};const ua={r:0,b:0,g:0},As=new Ei,hL=new zt;function uL(i,e,t,n,s,o,r){const a=new dt(0);let l=o===!0?0:1,c,h,u=null,d=0,m=null;function g(M){let S=M.isScene===!0?M.background:null;return S&&S.isTexture&&(S=(M.backgroundBlurriness>0?t:e).get(S)),S}function _(M){let S=!1;const x=g(M);x===null?f(a,l):x&&x.isColor&&(f(x,1),S=!0);const F=i.xr.getEnvironmentBlendMode();F==="additive"?n.buffers.color.setClear(0,0,0,1,r):F==="alpha-blend"&&n.buffers.color.setClear(0,0,0,0,r),(i.autoClear||S)&&(n.buffers.depth.setTest(!0),n.buffers.depth.setMask(!0),n.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function p(M,S){const x=g(S);x&&(x.isCubeTexture||x.mapping===Ya)?(h===void 0&&(h=new un(new $s(1,1,1),new ms({name:"BackgroundCubeMaterial",uniforms:zo(vi.backgroundCube.uniforms),vertexShader:vi.backgroundCube.vertexShader,fragmentShader:vi.backgroundCube.fragmentShader,side:Pn,depthTest:!1,depthWrite:!1,fog:!1})),h.geometry.deleteAttribute("normal"),h.geometry.deleteAttribute("uv"),h.onBeforeRender=function(F,P,A){this.matrixWorld.copyPosition(A.matrixWorld)},Object.defineProperty(h.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),s.update(h)),As.copy(S.backgroundRotation),As.x*=-1,As.y*=-1,As.z*=-1,x.isCubeTexture&&x.isRenderTargetTexture===!1&&(As.y*=-1,As.z*=-1),h.material.uniforms.envMap.value=x,h.material.uniforms.flipEnvMap.value=x.isCubeTexture&&x.isRenderTargetTexture===!1?-1:1,h.material.uniforms.backgroundBlurriness.value=S.backgroundBlurriness,h.material.uniforms.backgroundIntensity.value=S.backgroundIntensity,h.material.uniforms.backgroundRotation.value.setFromMatrix4(hL.makeRotationFromEuler(As)),h.material.toneMapped=gt.getTransfer(x.colorSpace)!==Rt,(u!==x||d!==x.version||m!==i.toneMapping)&&(h.material.needsUpdate=!0,u=x,d=x.version,m=i.toneMapping),h.layers.enableAll(),M.unshift(h,h.geometry,h.material,0,0,null)):x&&x.isTexture&&(c===void 0&&(c=new un(new Nr(2,2),new ms({name:"BackgroundMaterial",uniforms:zo(vi.background.uniforms),vertexShader:vi.background.vertexShader,fragmentShader:vi.background.fragmentShader,side:ps,depthTest:!1,depthWrite:!1,fog:!1})),c.geometry.deleteAttribute("normal"),Object.defineProperty(c.material,"map",{get:function(){return this.uniforms.t2D.value}}),s.update(c)),c.material.uniforms.t2D.value=x,c.material.uniforms.backgroundIntensity.value=S.backgroundIntensity,c.material.toneMapped=gt.getTransfer(x.colorSpace)!==Rt,x.matrixAutoUpdate===!0&&x.updateMatrix(),c.material.uniforms.uvTransform.value.copy(x.matrix),(u!==x||d!==x.version||m!==i.toneMapping)&&(c.material.needsUpdate=!0,u=x,d=x.version,m=i.toneMapping),c.layers.enableAll(),M.unshift(c,c.geometry,c.material,0,0,null))}function f(M,S){M.getRGB(ua,Sm(i)),n.buffers.color.setClear(ua.r,ua.g,ua.b,S,r)}return{getClearColor:function(){return a},setClearColor:function(M,S=1){a.set(M),l=S,f(a,l)},getClearAlpha:function(){return l},setClearAlpha:function(M){l=M,f(a,l)},render:_,addToRenderList:p}}function dL(i,e){const t=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=d(null);let o=s,r=!1;function a(y,R,V,O,$){let q=!1;const X=u(O,V,R);o!==X&&(o=X,c(o.object)),q=m(y,O,V,$),q&&g(y,O,V,$),$!==null&&e.update($,i.ELEMENT_ARRAY_BUFFER),(q||r)&&(r=!1,x(y,R,V,O),$!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,e.get($).buffer))}function l(){return i.createVertexArray()}function c(y){return i.bindVertexArray(y)}function h(y){return i.deleteVertexArray(y)}function u(y,R,V){const O=V.wireframe===!0;let $=n[y.id];$===void 0&&($={},n[y.id]=$);let q=$[R.id];q===void 0&&(q={},$[R.id]=q);let X=q[O];return X===void 0&&(X=d(l()),q[O]=X),X}function d(y){const R=[],V=[],O=[];for(let $=0;$<t;$++)R[$]=0,V[$]=0,O[$]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:R,enabledAttributes:V,attributeDivisors:O,object:y,attributes:{},index:null}}function m(y,R,V,O){const $=o.attributes,q=R.attributes;let X=0;const Y=V.getAttributes();for(const te in Y)if(Y[te].location>=0){const he=$[te];let _e=q[te];if(_e===void 0&&(te==="instanceMatrix"&&y.instanceMatrix&&(_e=y.instanceMatrix),te==="instanceColor"&&y.instanceColor&&(_e=y.instanceColor)),he===void 0||he.attribute!==_e||_e&&he.data!==_e.data)return!0;X++}return o.attributesNum!==X||o.index!==O}function g(y,R,V,O){const $={},q=R.attributes;let X=0;const Y=V.getAttributes();for(const te in Y)if(Y[te].location>=0){let he=q[te];he===void 0&&(te==="instanceMatrix"&&y.instanceMatrix&&(he=y.instanceMatrix),te==="instanceColor"&&y.instanceColor&&(he=y.instanceColor));const _e={};_e.attribute=he,he&&he.data&&(_e.data=he.data),$[te]=_e,X++}o.attributes=$,o.attributesNum=X,o.index=O}function _(){const y=o.newAttributes;for(let R=0,V=y.length;R<V;R++)y[R]=0}function p(y){f(y,0)}function f(y,R){const V=o.newAttributes,O=o.enabledAttributes,$=o.attributeDivisors;V[y]=1,O[y]===0&&(i.enableVertexAttribArray(y),O[y]=1),$[y]!==R&&(i.vertexAttribDivisor(y,R),$[y]=R)}function M(){const y=o.newAttributes,R=o.enabledAttributes;for(let V=0,O=R.length;V<O;V++)R[V]!==y[V]&&(i.disableVertexAttribArray(V),R[V]=0)}function S(y,R,V,O,$,q,X){X===!0?i.vertexAttribIPointer(y,R,V,$,q):i.vertexAttribPointer(y,R,V,O,$,q)}function x(y,R,V,O){_();const $=O.attributes,q=V.getAttributes(),X=R.defaultAttributeValues;for(const Y in q){const te=q[Y];if(te.location>=0){let le=$[Y];if(le===void 0&&(Y==="instanceMatrix"&&y.instanceMatrix&&(le=y.instanceMatrix),Y==="instanceColor"&&y.instanceColor&&(le=y.instanceColor)),le!==void 0){const he=le.normalized,_e=le.itemSize,Me=e.get(le);if(Me===void 0)continue;const ge=Me.buffer,oe=Me.type,ue=Me.bytesPerElement,ve=oe===i.INT||oe===i.UNSIGNED_INT||le.gpuType===Lh;if(le.isInterleavedBufferAttribute){const ce=le.data,He=ce.stride,Ge=le.offset;if(ce.isInstancedInterleavedBuffer){for(let ke=0;ke<te.locationSize;ke++)f(te.location+ke,ce.meshPerAttribute);y.isInstancedMesh!==!0&&O._maxInstanceCount===void 0&&(O._maxInstanceCount=ce.meshPerAttribute*ce.count)}else for(let ke=0;ke<te.locationSize;ke++)p(te.location+ke);i.bindBuffer(i.ARRAY_BUFFER,ge);for(let ke=0;ke<te.locationSize;ke++)S(te.location+ke,_e/te.locationSize,oe,he,He*ue,(Ge+_e/te.locationSize*ke)*ue,ve)}else{if(le.isInstancedBufferAttribute){for(let ce=0;ce<te.locationSize;ce++)f(te.location+ce,le.meshPerAttribute);y.isInstancedMesh!==!0&&O._maxInstanceCount===void 0&&(O._maxInstanceCount=le.meshPerAttribute*le.count)}else for(let ce=0;ce<te.locationSize;ce++)p(te.location+ce);i.bindBuffer(i.ARRAY_BUFFER,ge);for(let ce=0;ce<te.locationSize;ce++)S(te.location+ce,_e/te.locationSize,oe,he,_e*ue,_e/te.locationSize*ce*ue,ve)}}else if(X!==void 0){const he=X[Y];if(he!==void 0)switch(he.length){case 2:i.vertexAttrib2fv(te.location,he);break;case 3:i.vertexAttrib3fv(te.location,he);break;case 4:i.vertexAttrib4fv(te.location,he);break;default:i.vertexAttrib1fv(te.location,he)}}}}M()}function F(){I();for(const y in n){const R=n[y];for(const V in R){const O=R[V];for(const $ in O)h(O[$].object),delete O[$];delete R[V]}delete n[y]}}function P(y){if(n[y.id]===void 0)return;const R=n[y.id];for(const V in R){const O=R[V];for(const $ in O)h(O[$].object),delete O[$];delete R[V]}delete n[y.id]}function A(y){for(const R in n){const V=n[R];if(V[y.id]===void 0)continue;const O=V[y.id];for(const $ in O)h(O[$].object),delete O[$];delete V[y.id]}}function I(){E(),r=!0,o!==s&&(o=s,c(o.object))}function E(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:I,resetDefaultState:E,dispose:F,releaseStatesOfGeometry:P,releaseStatesOfProgram:A,initAttributes:_,enableAttribute:p,disableUnusedAttributes:M}}function fL(i,e,t){let n;function s(c){n=c}function o(c,h){i.drawArrays(n,c,h),t.update(h,n,1)}function r(c,h,u){u!==0&&(i.drawArraysInstanced(n,c,h,u),t.update(h,n,u))}function a(c,h,u){if(u===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,c,0,h,0,u);let m=0;for(let g=0;g<u;g++)m+=h[g];t.update(m,n,1)}function l(c,h,u,d){if(u===0)return;const m=e.get("WEBGL_multi_draw");if(m===null)for(let g=0;g<c.length;g++)r(c[g],h[g],d[g]);else{m.multiDrawArraysInstancedWEBGL(n,c,0,h,0,d,0,u);let g=0;for(let _=0;_<u;_++)g+=h[_]*d[_];t.update(g,n,1)}}this.setMode=s,this.render=o,this.renderInstances=r,this.renderMultiDraw=a,this.renderMultiDrawInstances=l}function pL(i,e,t,n){let s;function o(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){const A=e.get("EXT_texture_filter_anisotropic");s=i.getParameter(A.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function r(A){return!(A!==li&&n.convert(A)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(A){const I=A===Ar&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(A!==$i&&n.convert(A)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE)&&A!==Oi&&!I)}function l(A){if(A==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";A="mediump"}return A==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp";const h=l(c);h!==c&&(console.warn("THREE.WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);const u=t.logarithmicDepthBuffer===!0,d=t.reverseDepthBuffer===!0&&e.has("EXT_clip_control"),m=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),g=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),_=i.getParameter(i.MAX_TEXTURE_SIZE),p=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),f=i.getParameter(i.MAX_VERTEX_ATTRIBS),M=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),S=i.getParameter(i.MAX_VARYING_VECTORS),x=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),F=g>0,P=i.getParameter(i.MAX_SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:o,getMaxPrecision:l,textureFormatReadable:r,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:u,reverseDepthBuffer:d,maxTextures:m,maxVertexTextures:g,maxTextureSize:_,maxCubemapSize:p,maxAttributes:f,maxVertexUniforms:M,maxVaryings:S,maxFragmentUniforms:x,vertexTextures:F,maxSamples:P}}function mL(i){const e=this;let t=null,n=0,s=!1,o=!1;const r=new rs,a=new tt,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(u,d){const m=u.length!==0||d||n!==0||s;return s=d,n=u.length,m},this.beginShadows=function(){o=!0,h(null)},this.endShadows=function(){o=!1},this.setGlobalState=function(u,d){t=h(u,d,0)},this.setState=function(u,d,m){const g=u.clippingPlanes,_=u.clipIntersection,p=u.clipShadows,f=i.get(u);if(!s||g===null||g.length===0||o&&!p)o?h(null):c();else{const M=o?0:n,S=M*4;let x=f.clippingState||null;l.value=x,x=h(g,d,S,m);for(let F=0;F!==S;++F)x[F]=t[F];f.clippingState=x,this.numIntersection=_?this.numPlanes:0,this.numPlanes+=M}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=n>0),e.numPlanes=n,e.numIntersection=0}function h(u,d,m,g){const _=u!==null?u.length:0;let p=null;if(_!==0){if(p=l.value,g!==!0||p===null){const f=m+_*4,M=d.matrixWorldInverse;a.getNormalMatrix(M),(p===null||p.length<f)&&(p=new Float32Array(f));for(let S=0,x=m;S!==_;++S,x+=4)r.copy(u[S]).applyMatrix4(M,a),r.normal.toArray(p,x),p[x+3]=r.constant}l.value=p,l.needsUpdate=!0}return e.numPlanes=_,e.numIntersection=0,p}}function gL(i){let e=new WeakMap;function t(r,a){return a===wc?r.mapping=ko:a===Ec&&(r.mapping=Fo),r}function n(r){if(r&&r.isTexture){const a=r.mapping;if(a===wc||a===Ec)if(e.has(r)){const l=e.get(r).texture;return t(l,r.mapping)}else{const l=r.image;if(l&&l.height>0){const c=new AC(l.height);return c.fromEquirectangularTexture(i,r),e.set(r,c),r.addEventListener("dispose",s),t(c.texture,r.mapping)}else return null}}return r}function s(r){const a=r.target;a.removeEventListener("dispose",s);const l=e.get(a);l!==void 0&&(e.delete(a),l.dispose())}function o(){e=new WeakMap}return{get:n,dispose:o}}class Am extends wm{constructor(e=-1,t=1,n=1,s=-1,o=.1,r=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=n,this.bottom=s,this.near=o,this.far=r,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,n,s,o,r){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=o,this.view.height=r,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){const e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2;let o=n-e,r=n+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){const c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;o+=c*this.view.offsetX,r=o+c*this.view.width,a-=h*this.view.offsetY,l=a-h*this.view.height}this.projectionMatrix.makeOrthographic(o,r,a,l,this.near,this.far,this.coordinateSystem),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){const t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}}const Eo=4,tf=[.125,.215,.35,.446,.526,.582],ks=20,$l=new Am,nf=new dt;let ql=null,Xl=0,jl=0,Yl=!1;const Ns=(1+Math.sqrt(5))/2,bo=1/Ns,sf=[new ee(-Ns,bo,0),new ee(Ns,bo,0),new ee(-bo,0,Ns),new ee(bo,0,Ns),new ee(0,Ns,-bo),new ee(0,Ns,bo),new ee(-1,1,-1),new ee(1,1,-1),new ee(-1,1,1),new ee(1,1,1)];class of{constructor(e){this._renderer=e,this._pingPongRenderTarget=null,this._lodMax=0,this._cubeSize=0,this._lodPlanes=[],this._sizeLods=[],this._sigmas=[],this._blurMaterial=null,this._cubemapMaterial=null,this._equirectMaterial=null,this._compileMaterial(this._blurMaterial)}fromScene(e,t=0,n=.1,s=100){ql=this._renderer.getRenderTarget(),Xl=this._renderer.getActiveCubeFace(),jl=this._renderer.getActiveMipmapLevel(),Yl=this._renderer.xr.enabled,this._renderer.xr.enabled=!1,this._setSize(256);const o=this._allocateTargets();return o.depthBuffer=!0,this._sceneToCubeUV(e,n,s,o),t>0&&this._blur(o,0,0,t),this._applyPMREM(o),this._cleanup(o),o}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=lf(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=af(),this._compileMaterial(this._equirectMaterial))}dispose(){this._dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose()}_setSize(e){this._lodMax=Math.floor(Math.log2(e)),this._cubeSize=Math.pow(2,this._lodMax)}_dispose(){this._blurMaterial!==null&&this._blurMaterial.dispose(),this._pingPongRenderTarget!==null&&this._pingPongRenderTarget.dispose();for(let e=0;e<this._lodPlanes.length;e++)this._lodPlanes[e].dispose()}_cleanup(e){this._renderer.setRenderTarget(ql,Xl,jl),this._renderer.xr.enabled=Yl,e.scissorTest=!1,da(e,0,0,e.width,e.height)}_fromTexture(e,t){e.mapping===ko||e.mapping===Fo?this._setSize(e.image.length===0?16:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4),ql=this._renderer.getRenderTarget(),Xl=this._renderer.getActiveCubeFace(),jl=this._renderer.getActiveMipmapLevel(),Yl=this._renderer.xr.enabled,this._renderer.xr.enabled=!1;const n=t||this._allocateTargets();return this._textureToCubeUV(e,n),this._applyPMREM(n),this._cleanup(n),n}_allocateTargets(){const e=3*Math.max(this._cubeSize,112),t=4*this._cubeSize,n={magFilter:bi,minFilter:bi,generateMipmaps:!1,type:Ar,format:li,colorSpace:qo,depthBuffer:!1},s=rf(e,t,n);if(this._pingPongRenderTarget===null||this._pingPongRenderTarget.width!==e||this._pingPongRenderTarget.height!==t){this._pingPongRenderTarget!==null&&this._dispose(),this._pingPongRenderTarget=rf(e,t,n);const{_lodMax:o}=this;({sizeLods:this._sizeLods,lodPlanes:this._lodPlanes,sigmas:this._sigmas}=_L(o)),this._blurMaterial=vL(o,e,t)}return s}_compileMaterial(e){const t=new un(this._lodPlanes[0],e);this._renderer.compile(t,$l)}_sceneToCubeUV(e,t,n,s){const a=new Yn(90,1,t,n),l=[1,-1,1,1,1,1],c=[1,1,1,-1,-1,-1],h=this._renderer,u=h.autoClear,d=h.toneMapping;h.getClearColor(nf),h.toneMapping=hs,h.autoClear=!1;const m=new Bh({name:"PMREM.Background",side:Pn,depthWrite:!1,depthTest:!1}),g=new un(new $s,m);let _=!1;const p=e.background;p?p.isColor&&(m.color.copy(p),e.background=null,_=!0):(m.color.copy(nf),_=!0);for(let f=0;f<6;f++){const M=f%3;M===0?(a.up.set(0,l[f],0),a.lookAt(c[f],0,0)):M===1?(a.up.set(0,0,l[f]),a.lookAt(0,c[f],0)):(a.up.set(0,l[f],0),a.lookAt(0,0,c[f]));const S=this._cubeSize;da(s,M*S,f>2?S:0,S,S),h.setRenderTarget(s),_&&h.render(g,a),h.render(e,a)}g.geometry.dispose(),g.material.dispose(),h.toneMapping=d,h.autoClear=u,e.background=p}_textureToCubeUV(e,t){const n=this._renderer,s=e.mapping===ko||e.mapping===Fo;s?(this._cubemapMaterial===null&&(this._cubemapMaterial=lf()),this._cubemapMaterial.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):this._equirectMaterial===null&&(this._equirectMaterial=af());const o=s?this._cubemapMaterial:this._equirectMaterial,r=new un(this._lodPlanes[0],o),a=o.uniforms;a.envMap.value=e;const l=this._cubeSize;da(t,0,0,3*l,2*l),n.setRenderTarget(t),n.render(r,$l)}_applyPMREM(e){const t=this._renderer,n=t.autoClear;t.autoClear=!1;const s=this._lodPlanes.length;for(let o=1;o<s;o++){const r=Math.sqrt(this._sigmas[o]*this._sigmas[o]-this._sigmas[o-1]*this._sigmas[o-1]),a=sf[(s-o-1)%sf.length];this._blur(e,o-1,o,r,a)}t.autoClear=n}_blur(e,t,n,s,o){const r=this._pingPongRenderTarget;this._halfBlur(e,r,t,n,s,"latitudinal",o),this._halfBlur(r,e,n,n,s,"longitudinal",o)}_halfBlur(e,t,n,s,o,r,a){const l=this._renderer,c=this._blurMaterial;r!=="latitudinal"&&r!=="longitudinal"&&console.error("blur direction must be either latitudinal or longitudinal!");const h=3,u=new un(this._lodPlanes[s],c),d=c.uniforms,m=this._sizeLods[n]-1,g=isFinite(o)?Math.PI/(2*m):2*Math.PI/(2*ks-1),_=o/g,p=isFinite(o)?1+Math.floor(h*_):ks;p>ks&&console.warn(`sigmaRadians, ${o}, is too large and will clip, as it requested ${p} samples when the maximum is set to ${ks}`);const f=[];let M=0;for(let A=0;A<ks;++A){const I=A/_,E=Math.exp(-I*I/2);f.push(E),A===0?M+=E:A<p&&(M+=2*E)}for(let A=0;A<f.length;A++)f[A]=f[A]/M;d.envMap.value=e.texture,d.samples.value=p,d.weights.value=f,d.latitudinal.value=r==="latitudinal",a&&(d.poleAxis.value=a);const{_lodMax:S}=this;d.dTheta.value=g,d.mipInt.value=S-n;const x=this._sizeLods[s],F=3*x*(s>S-Eo?s-S+Eo:0),P=4*(this._cubeSize-x);da(t,F,P,3*x,2*x),l.setRenderTarget(t),l.render(u,$l)}}function _L(i){const e=[],t=[],n=[];let s=i;const o=i-Eo+1+tf.length;for(let r=0;r<o;r++){const a=Math.pow(2,s);t.push(a);let l=1/a;r>i-Eo?l=tf[r-i+Eo-1]:r===0&&(l=0),n.push(l);const c=1/(a-2),h=-c,u=1+c,d=[h,h,u,h,u,u,h,h,u,u,h,u],m=6,g=6,_=3,p=2,f=1,M=new Float32Array(_*g*m),S=new Float32Array(p*g*m),x=new Float32Array(f*g*m);for(let P=0;P<m;P++){const A=P%3*2/3-1,I=P>2?0:-1,E=[A,I,0,A+2/3,I,0,A+2/3,I+1,0,A,I,0,A+2/3,I+1,0,A,I+1,0];M.set(E,_*g*P),S.set(d,p*g*P);const y=[P,P,P,P,P,P];x.set(y,f*g*P)}const F=new gs;F.setAttribute("position",new Mi(M,_)),F.setAttribute("uv",new Mi(S,p)),F.setAttribute("faceIndex",new Mi(x,f)),e.push(F),s>Eo&&s--}return{lodPlanes:e,sizeLods:t,sigmas:n}}function rf(i,e,t){const n=new Ws(i,e,t);return n.texture.mapping=Ya,n.texture.name="PMREM.cubeUv",n.scissorTest=!0,n}function da(i,e,t,n,s){i.viewport.set(e,t,n,s),i.scissor.set(e,t,n,s)}function vL(i,e,t){const n=new Float32Array(ks),s=new ee(0,1,0);return new ms({name:"SphericalGaussianBlur",defines:{n:ks,CUBEUV_TEXEL_WIDTH:1/e,CUBEUV_TEXEL_HEIGHT:1/t,CUBEUV_MAX_MIP:`${i}.0`},uniforms:{envMap:{value:null},samples:{value:1},weights:{value:n},latitudinal:{value:!1},dTheta:{value:0},mipInt:{value:0},poleAxis:{value:s}},vertexShader:Hh(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			varying vec3 vOutputDirection;

			uniform sampler2D envMap;
			uniform int samples;
			uniform float weights[ n ];
			uniform bool latitudinal;
			uniform float dTheta;
			uniform float mipInt;
			uniform vec3 poleAxis;

			#define ENVMAP_TYPE_CUBE_UV
			#include <cube_uv_reflection_fragment>

			vec3 getSample( float theta, vec3 axis ) {

				float cosTheta = cos( theta );
				// Rodrigues' axis-angle rotation
				vec3 sampleDirection = vOutputDirection * cosTheta
					+ cross( axis, vOutputDirection ) * sin( theta )
					+ axis * dot( axis, vOutputDirection ) * ( 1.0 - cosTheta );

				return bilinearCubeUV( envMap, sampleDirection, mipInt );

			}

			void main() {

				vec3 axis = latitudinal ? poleAxis : cross( poleAxis, vOutputDirection );

				if ( all( equal( axis, vec3( 0.0 ) ) ) ) {

					axis = vec3( vOutputDirection.z, 0.0, - vOutputDirection.x );

				}

				axis = normalize( axis );

				gl_FragColor = vec4( 0.0, 0.0, 0.0, 1.0 );
				gl_FragColor.rgb += weights[ 0 ] * getSample( 0.0, axis );

				for ( int i = 1; i < n; i++ ) {

					if ( i >= samples ) {

						break;

					}

					float theta = dTheta * float( i );
					gl_FragColor.rgb += weights[ i ] * getSample( -1.0 * theta, axis );
					gl_FragColor.rgb += weights[ i ] * getSample( theta, axis );

				}

			}
		`,blending:cs,depthTest:!1,depthWrite:!1})}function af(){return new ms({name:"EquirectangularToCubeUV",uniforms:{envMap:{value:null}},vertexShader:Hh(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			varying vec3 vOutputDirection;

			uniform sampler2D envMap;

			#include <common>

			void main() {

				vec3 outputDirection = normalize( vOutputDirection );
				vec2 uv = equirectUv( outputDirection );

				gl_FragColor = vec4( texture2D ( envMap, uv ).rgb, 1.0 );

			}
		`,blending:cs,depthTest:!1,depthWrite:!1})}function lf(){return new ms({name:"CubemapToCubeUV",uniforms:{envMap:{value:null},flipEnvMap:{value:-1}},vertexShader:Hh(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			uniform float flipEnvMap;

			varying vec3 vOutputDirection;

			uniform samplerCube envMap;

			void main() {

				gl_FragColor = textureCube( envMap, vec3( flipEnvMap * vOutputDirection.x, vOutputDirection.yz ) );

			}
		`,blending:cs,depthTest:!1,depthWrite:!1})}function Hh(){return`

		precision mediump float;
		precision mediump int;

		attribute float faceIndex;

		varying vec3 vOutputDirection;

		// RH coordinate system; PMREM face-indexing convention
		vec3 getDirection( vec2 uv, float face ) {

			uv = 2.0 * uv - 1.0;

			vec3 direction = vec3( uv, 1.0 );

			if ( face == 0.0 ) {

				direction = direction.zyx; // ( 1, v, u ) pos x

			} else if ( face == 1.0 ) {

				direction = direction.xzy;
				direction.xz *= -1.0; // ( -u, 1, -v ) pos y

			} else if ( face == 2.0 ) {

				direction.x *= -1.0; // ( -u, v, 1 ) pos z

			} else if ( face == 3.0 ) {

				direction = direction.zyx;
				direction.xz *= -1.0; // ( -1, v, -u ) neg x

			} else if ( face == 4.0 ) {

				direction = direction.xzy;
				direction.xy *= -1.0; // ( -u, -1, v ) neg y

			} else if ( face == 5.0 ) {

				direction.z *= -1.0; // ( u, v, -1 ) neg z

			}

			return direction;

		}

		void main() {

			vOutputDirection = getDirection( uv, faceIndex );
			gl_Position = vec4( position, 1.0 );

		}
	`}function xL(i){let e=new WeakMap,t=null;function n(a){if(a&&a.isTexture){const l=a.mapping,c=l===wc||l===Ec,h=l===ko||l===Fo;if(c||h){let u=e.get(a);const d=u!==void 0?u.texture.pmremVersion:0;if(a.isRenderTargetTexture&&a.pmremVersion!==d)return t===null&&(t=new of(i)),u=c?t.fromEquirectangular(a,u):t.fromCubemap(a,u),u.texture.pmremVersion=a.pmremVersion,e.set(a,u),u.texture;if(u!==void 0)return u.texture;{const m=a.image;return c&&m&&m.height>0||h&&m&&s(m)?(t===null&&(t=new of(i)),u=c?t.fromEquirectangular(a):t.fromCubemap(a),u.texture.pmremVersion=a.pmremVersion,e.set(a,u),a.addEventListener("dispose",o),u.texture):null}}}return a}function s(a){let l=0;const c=6;for(let h=0;h<c;h++)a[h]!==void 0&&l++;return l===c}function o(a){const l=a.target;l.removeEventListener("dispose",o);const c=e.get(l);c!==void 0&&(e.delete(l),c.dispose())}function r(){e=new WeakMap,t!==null&&(t.dispose(),t=null)}return{get:n,dispose:r}}function bL(i){const e={};function t(n){if(e[n]!==void 0)return e[n];let s;switch(n){case"WEBGL_depth_texture":s=i.getExtension("WEBGL_depth_texture")||i.getExtension("MOZ_WEBGL_depth_texture")||i.getExtension("WEBKIT_WEBGL_depth_texture");break;case"EXT_texture_filter_anisotropic":s=i.getExtension("EXT_texture_filter_anisotropic")||i.getExtension("MOZ_EXT_texture_filter_anisotropic")||i.getExtension("WEBKIT_EXT_texture_filter_anisotropic");break;case"WEBGL_compressed_texture_s3tc":s=i.getExtension("WEBGL_compressed_texture_s3tc")||i.getExtension("MOZ_WEBGL_compressed_texture_s3tc")||i.getExtension("WEBKIT_WEBGL_compressed_texture_s3tc");break;case"WEBGL_compressed_texture_pvrtc":s=i.getExtension("WEBGL_compressed_texture_pvrtc")||i.getExtension("WEBKIT_WEBGL_compressed_texture_pvrtc");break;default:s=i.getExtension(n)}return e[n]=s,s}return{has:function(n){return t(n)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(n){const s=t(n);return s===null&&pr("THREE.WebGLRenderer: "+n+" extension not supported."),s}}}function yL(i,e,t,n){const s={},o=new WeakMap;function r(u){const d=u.target;d.index!==null&&e.remove(d.index);for(const g in d.attributes)e.remove(d.attributes[g]);for(const g in d.morphAttributes){const _=d.morphAttributes[g];for(let p=0,f=_.length;p<f;p++)e.remove(_[p])}d.removeEventListener("dispose",r),delete s[d.id];const m=o.get(d);m&&(e.remove(m),o.delete(d)),n.releaseStatesOfGeometry(d),d.isInstancedBufferGeometry===!0&&delete d._maxInstanceCount,t.memory.geometries--}function a(u,d){return s[d.id]===!0||(d.addEventListener("dispose",r),s[d.id]=!0,t.memory.geometries++),d}function l(u){const d=u.attributes;for(const g in d)e.update(d[g],i.ARRAY_BUFFER);const m=u.morphAttributes;for(const g in m){const _=m[g];for(let p=0,f=_.length;p<f;p++)e.update(_[p],i.ARRAY_BUFFER)}}function c(u){const d=[],m=u.index,g=u.attributes.position;let _=0;if(m!==null){const M=m.array;_=m.version;for(let S=0,x=M.length;S<x;S+=3){const F=M[S+0],P=M[S+1],A=M[S+2];d.push(F,P,P,A,A,F)}}else if(g!==void 0){const M=g.array;_=g.version;for(let S=0,x=M.length/3-1;S<x;S+=3){const F=S+0,P=S+1,A=S+2;d.push(F,P,P,A,A,F)}}else return;const p=new(gm(d)?Mm:ym)(d,1);p.version=_;const f=o.get(u);f&&e.remove(f),o.set(u,p)}function h(u){const d=o.get(u);if(d){const m=u.index;m!==null&&d.version<m.version&&c(u)}else c(u);return o.get(u)}return{get:a,update:l,getWireframeAttribute:h}}function ML(i,e,t){let n;function s(d){n=d}let o,r;function a(d){o=d.type,r=d.bytesPerElement}function l(d,m){i.drawElements(n,m,o,d*r),t.update(m,n,1)}function c(d,m,g){g!==0&&(i.drawElementsInstanced(n,m,o,d*r,g),t.update(m,n,g))}function h(d,m,g){if(g===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,m,0,o,d,0,g);let p=0;for(let f=0;f<g;f++)p+=m[f];t.update(p,n,1)}function u(d,m,g,_){if(g===0)return;const p=e.get("WEBGL_multi_draw");if(p===null)for(let f=0;f<d.length;f++)c(d[f]/r,m[f],_[f]);else{p.multiDrawElementsInstancedWEBGL(n,m,0,o,d,0,_,0,g);let f=0;for(let M=0;M<g;M++)f+=m[M]*_[M];t.update(f,n,1)}}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=h,this.renderMultiDrawInstances=u}function SL(i){const e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function n(o,r,a){switch(t.calls++,r){case i.TRIANGLES:t.triangles+=a*(o/3);break;case i.LINES:t.lines+=a*(o/2);break;case i.LINE_STRIP:t.lines+=a*(o-1);break;case i.LINE_LOOP:t.lines+=a*o;break;case i.POINTS:t.points+=a*o;break;default:console.error("THREE.WebGLInfo: Unknown draw mode:",r);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:n}}function wL(i,e,t){const n=new WeakMap,s=new Gt;function o(r,a,l){const c=r.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,u=h!==void 0?h.length:0;let d=n.get(a);if(d===void 0||d.count!==u){let y=function(){I.dispose(),n.delete(a),a.removeEventListener("dispose",y)};var m=y;d!==void 0&&d.texture.dispose();const g=a.morphAttributes.position!==void 0,_=a.morphAttributes.normal!==void 0,p=a.morphAttributes.color!==void 0,f=a.morphAttributes.position||[],M=a.morphAttributes.normal||[],S=a.morphAttributes.color||[];let x=0;g===!0&&(x=1),_===!0&&(x=2),p===!0&&(x=3);let F=a.attributes.position.count*x,P=1;F>e.maxTextureSize&&(P=Math.ceil(F/e.maxTextureSize),F=e.maxTextureSize);const A=new Float32Array(F*P*4*u),I=new vm(A,F,P,u);I.type=Oi,I.needsUpdate=!0;const E=x*4;for(let R=0;R<u;R++){const V=f[R],O=M[R],$=S[R],q=F*P*4*R;for(let X=0;X<V.count;X++){const Y=X*E;g===!0&&(s.fromBufferAttribute(V,X),A[q+Y+0]=s.x,A[q+Y+1]=s.y,A[q+Y+2]=s.z,A[q+Y+3]=0),_===!0&&(s.fromBufferAttribute(O,X),A[q+Y+4]=s.x,A[q+Y+5]=s.y,A[q+Y+6]=s.z,A[q+Y+7]=0),p===!0&&(s.fromBufferAttribute($,X),A[q+Y+8]=s.x,A[q+Y+9]=s.y,A[q+Y+10]=s.z,A[q+Y+11]=$.itemSize===4?s.w:1)}}d={count:u,texture:I,size:new vt(F,P)},n.set(a,d),a.addEventListener("dispose",y)}if(r.isInstancedMesh===!0&&r.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",r.morphTexture,t);else{let g=0;for(let p=0;p<c.length;p++)g+=c[p];const _=a.morphTargetsRelative?1:1-g;l.getUniforms().setValue(i,"morphTargetBaseInfluence",_),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",d.texture,t),l.getUniforms().setValue(i,"morphTargetsTextureSize",d.size)}return{update:o}}function EL(i,e,t,n){let s=new WeakMap;function o(l){const c=n.render.frame,h=l.geometry,u=e.get(l,h);if(s.get(u)!==c&&(e.update(u),s.set(u,c)),l.isInstancedMesh&&(l.hasEventListener("dispose",a)===!1&&l.addEventListener("dispose",a),s.get(l)!==c&&(t.update(l.instanceMatrix,i.ARRAY_BUFFER),l.instanceColor!==null&&t.update(l.instanceColor,i.ARRAY_BUFFER),s.set(l,c))),l.isSkinnedMesh){const d=l.skeleton;s.get(d)!==c&&(d.update(),s.set(d,c))}return u}function r(){s=new WeakMap}function a(l){const c=l.target;c.removeEventListener("dispose",a),t.remove(c.instanceMatrix),c.instanceColor!==null&&t.remove(c.instanceColor)}return{update:o,dispose:r}}class Rm extends En{constructor(e,t,n,s,o,r,a,l,c,h=Ro){if(h!==Ro&&h!==Bo)throw new Error("DepthTexture format must be either THREE.DepthFormat or THREE.DepthStencilFormat");n===void 0&&h===Ro&&(n=Gs),n===void 0&&h===Bo&&(n=Oo),super(null,s,o,r,a,l,h,n,c),this.isDepthTexture=!0,this.image={width:e,height:t},this.magFilter=a!==void 0?a:ci,this.minFilter=l!==void 0?l:ci,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.compareFunction=e.compareFunction,this}toJSON(e){const t=super.toJSON(e);return this.compareFunction!==null&&(t.compareFunction=this.compareFunction),t}}const Cm=new En,cf=new Rm(1,1),Pm=new vm,Lm=new uC,Nm=new Em,hf=[],uf=[],df=new Float32Array(16),ff=new Float32Array(9),pf=new Float32Array(4);function jo(i,e,t){const n=i[0];if(n<=0||n>0)return i;const s=e*t;let o=hf[s];if(o===void 0&&(o=new Float32Array(s),hf[s]=o),e!==0){n.toArray(o,0);for(let r=1,a=0;r!==e;++r)a+=t,i[r].toArray(o,a)}return o}function en(i,e){if(i.length!==e.length)return!1;for(let t=0,n=i.length;t<n;t++)if(i[t]!==e[t])return!1;return!0}function tn(i,e){for(let t=0,n=e.length;t<n;t++)i[t]=e[t]}function Za(i,e){let t=uf[e];t===void 0&&(t=new Int32Array(e),uf[e]=t);for(let n=0;n!==e;++n)t[n]=i.allocateTextureUnit();return t}function TL(i,e){const t=this.cache;t[0]!==e&&(i.uniform1f(this.addr,e),t[0]=e)}function AL(i,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(en(t,e))return;i.uniform2fv(this.addr,e),tn(t,e)}}function RL(i,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(i.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(en(t,e))return;i.uniform3fv(this.addr,e),tn(t,e)}}function CL(i,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(en(t,e))return;i.uniform4fv(this.addr,e),tn(t,e)}}function PL(i,e){const t=this.cache,n=e.elements;if(n===void 0){if(en(t,e))return;i.uniformMatrix2fv(this.addr,!1,e),tn(t,e)}else{if(en(t,n))return;pf.set(n),i.uniformMatrix2fv(this.addr,!1,pf),tn(t,n)}}function LL(i,e){const t=this.cache,n=e.elements;if(n===void 0){if(en(t,e))return;i.uniformMatrix3fv(this.addr,!1,e),tn(t,e)}else{if(en(t,n))return;ff.set(n),i.uniformMatrix3fv(this.addr,!1,ff),tn(t,n)}}function NL(i,e){const t=this.cache,n=e.elements;if(n===void 0){if(en(t,e))return;i.uniformMatrix4fv(this.addr,!1,e),tn(t,e)}else{if(en(t,n))return;df.set(n),i.uniformMatrix4fv(this.addr,!1,df),tn(t,n)}}function DL(i,e){const t=this.cache;t[0]!==e&&(i.uniform1i(this.addr,e),t[0]=e)}function IL(i,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(en(t,e))return;i.uniform2iv(this.addr,e),tn(t,e)}}function UL(i,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(en(t,e))return;i.uniform3iv(this.addr,e),tn(t,e)}}function kL(i,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(en(t,e))return;i.uniform4iv(this.addr,e),tn(t,e)}}function FL(i,e){const t=this.cache;t[0]!==e&&(i.uniform1ui(this.addr,e),t[0]=e)}function OL(i,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(en(t,e))return;i.uniform2uiv(this.addr,e),tn(t,e)}}function BL(i,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(en(t,e))return;i.uniform3uiv(this.addr,e),tn(t,e)}}function zL(i,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(en(t,e))return;i.uniform4uiv(this.addr,e),tn(t,e)}}function HL(i,e,t){const n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let o;this.type===i.SAMPLER_2D_SHADOW?(cf.compareFunction=mm,o=cf):o=Cm,t.setTexture2D(e||o,s)}function VL(i,e,t){const n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture3D(e||Lm,s)}function GL(i,e,t){const n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTextureCube(e||Nm,s)}function WL(i,e,t){const n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture2DArray(e||Pm,s)}function $L(i){switch(i){case 5126:return TL;case 35664:return AL;case 35665:return RL;case 35666:return CL;case 35674:return PL;case 35675:return LL;case 35676:return NL;case 5124:case 35670:return DL;case 35667:case 35671:return IL;case 35668:case 35672:return UL;case 35669:case 35673:return kL;case 5125:return FL;case 36294:return OL;case 36295:return BL;case 36296:return zL;case 35678:case 36198:case 36298:case 36306:case 35682:return HL;case 35679:case 36299:case 36307:return VL;case 35680:case 36300:case 36308:case 36293:return GL;case 36289:case 36303:case 36311:case 36292:return WL}}function qL(i,e){i.uniform1fv(this.addr,e)}function XL(i,e){const t=jo(e,this.size,2);i.uniform2fv(this.addr,t)}function jL(i,e){const t=jo(e,this.size,3);i.uniform3fv(this.addr,t)}function YL(i,e){const t=jo(e,this.size,4);i.uniform4fv(this.addr,t)}function KL(i,e){const t=jo(e,this.size,4);i.uniformMatrix2fv(this.addr,!1,t)}function ZL(i,e){const t=jo(e,this.size,9);i.uniformMatrix3fv(this.addr,!1,t)}function JL(i,e){const t=jo(e,this.size,16);i.uniformMatrix4fv(this.addr,!1,t)}function QL(i,e){i.uniform1iv(this.addr,e)}function eN(i,e){i.uniform2iv(this.addr,e)}function tN(i,e){i.uniform3iv(this.addr,e)}function nN(i,e){i.uniform4iv(this.addr,e)}function iN(i,e){i.uniform1uiv(this.addr,e)}function sN(i,e){i.uniform2uiv(this.addr,e)}function oN(i,e){i.uniform3uiv(this.addr,e)}function rN(i,e){i.uniform4uiv(this.addr,e)}function aN(i,e,t){const n=this.cache,s=e.length,o=Za(t,s);en(n,o)||(i.uniform1iv(this.addr,o),tn(n,o));for(let r=0;r!==s;++r)t.setTexture2D(e[r]||Cm,o[r])}function lN(i,e,t){const n=this.cache,s=e.length,o=Za(t,s);en(n,o)||(i.uniform1iv(this.addr,o),tn(n,o));for(let r=0;r!==s;++r)t.setTexture3D(e[r]||Lm,o[r])}function cN(i,e,t){const n=this.cache,s=e.length,o=Za(t,s);en(n,o)||(i.uniform1iv(this.addr,o),tn(n,o));for(let r=0;r!==s;++r)t.setTextureCube(e[r]||Nm,o[r])}function hN(i,e,t){const n=this.cache,s=e.length,o=Za(t,s);en(n,o)||(i.uniform1iv(this.addr,o),tn(n,o));for(let r=0;r!==s;++r)t.setTexture2DArray(e[r]||Pm,o[r])}function uN(i){switch(i){case 5126:return qL;case 35664:return XL;case 35665:return jL;case 35666:return YL;case 35674:return KL;case 35675:return ZL;case 35676:return JL;case 5124:case 35670:return QL;case 35667:case 35671:return eN;case 35668:case 35672:return tN;case 35669:case 35673:return nN;case 5125:return iN;case 36294:return sN;case 36295:return oN;case 36296:return rN;case 35678:case 36198:case 36298:case 36306:case 35682:return aN;case 35679:case 36299:case 36307:return lN;case 35680:case 36300:case 36308:case 36293:return cN;case 36289:case 36303:case 36311:case 36292:return hN}}class dN{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.setValue=$L(t.type)}}class fN{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=uN(t.type)}}class pN{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,n){const s=this.seq;for(let o=0,r=s.length;o!==r;++o){const a=s[o];a.setValue(e,t[a.id],n)}}}const Kl=/(\w+)(\])?(\[|\.)?/g;function mf(i,e){i.seq.push(e),i.map[e.id]=e}function mN(i,e,t){const n=i.name,s=n.length;for(Kl.lastIndex=0;;){const o=Kl.exec(n),r=Kl.lastIndex;let a=o[1];const l=o[2]==="]",c=o[3];if(l&&(a=a|0),c===void 0||c==="["&&r+2===s){mf(t,c===void 0?new dN(a,i,e):new fN(a,i,e));break}else{let u=t.map[a];u===void 0&&(u=new pN(a),mf(t,u)),t=u}}}class Ea{constructor(e,t){this.seq=[],this.map={};const n=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let s=0;s<n;++s){const o=e.getActiveUniform(t,s),r=e.getUniformLocation(t,o.name);mN(o,r,this)}}setValue(e,t,n,s){const o=this.map[t];o!==void 0&&o.setValue(e,n,s)}setOptional(e,t,n){const s=t[n];s!==void 0&&this.setValue(e,n,s)}static upload(e,t,n,s){for(let o=0,r=t.length;o!==r;++o){const a=t[o],l=n[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){const n=[];for(let s=0,o=e.length;s!==o;++s){const r=e[s];r.id in t&&n.push(r)}return n}}function gf(i,e,t){const n=i.createShader(e);return i.shaderSource(n,t),i.compileShader(n),n}const gN=37297;let _N=0;function vN(i,e){const t=i.split(`
`),n=[],s=Math.max(e-6,0),o=Math.min(e+6,t.length);for(let r=s;r<o;r++){const a=r+1;n.push(`${a===e?">":" "} ${a}: ${t[r]}`)}return n.join(`
`)}const _f=new tt;function xN(i){gt._getMatrix(_f,gt.workingColorSpace,i);const e=`mat3( ${_f.elements.map(t=>t.toFixed(4))} )`;switch(gt.getTransfer(i)){case Ka:return[e,"LinearTransferOETF"];case Rt:return[e,"sRGBTransferOETF"];default:return console.warn("THREE.WebGLProgram: Unsupported color space: ",i),[e,"LinearTransferOETF"]}}function vf(i,e,t){const n=i.getShaderParameter(e,i.COMPILE_STATUS),s=i.getShaderInfoLog(e).trim();if(n&&s==="")return"";const o=/ERROR: 0:(\d+)/.exec(s);if(o){const r=parseInt(o[1]);return t.toUpperCase()+`

`+s+`

`+vN(i.getShaderSource(e),r)}else return s}function bN(i,e){const t=xN(e);return[`vec4 ${i}( vec4 value ) {`,`	return ${t[1]}( vec4( value.rgb * ${t[0]}, value.a ) );`,"}"].join(`
`)}function yN(i,e){let t;switch(e){case OR:t="Linear";break;case BR:t="Reinhard";break;case zR:t="Cineon";break;case HR:t="ACESFilmic";break;case GR:t="AgX";break;case WR:t="Neutral";break;case VR:t="Custom";break;default:console.warn("THREE.WebGLProgram: Unsupported toneMapping:",e),t="Linear"}return"vec3 "+i+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}const fa=new ee;function MN(){gt.getLuminanceCoefficients(fa);const i=fa.x.toFixed(4),e=fa.y.toFixed(4),t=fa.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function SN(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(mr).join(`
`)}function wN(i){const e=[];for(const t in i){const n=i[t];n!==!1&&e.push("#define "+t+" "+n)}return e.join(`
`)}function EN(i,e){const t={},n=i.getProgramParameter(e,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){const o=i.getActiveAttrib(e,s),r=o.name;let a=1;o.type===i.FLOAT_MAT2&&(a=2),o.type===i.FLOAT_MAT3&&(a=3),o.type===i.FLOAT_MAT4&&(a=4),t[r]={type:o.type,location:i.getAttribLocation(e,r),locationSize:a}}return t}function mr(i){return i!==""}function xf(i,e){const t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return i.replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows)}function bf(i,e){return i.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}const TN=/^[ \t]*#include +<([\w\d./]+)>/gm;function eh(i){return i.replace(TN,RN)}const AN=new Map;function RN(i,e){let t=it[e];if(t===void 0){const n=AN.get(e);if(n!==void 0)t=it[n],console.warn('THREE.WebGLRenderer: Shader chunk "%s" has been deprecated. Use "%s" instead.',e,n);else throw new Error("Can not resolve #include <"+e+">")}return eh(t)}const CN=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function yf(i){return i.replace(CN,PN)}function PN(i,e,t,n){let s="";for(let o=parseInt(e);o<parseInt(t);o++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+o+" ]").replace(/UNROLLED_LOOP_INDEX/g,o);return s}function Mf(i){let e=`precision ${i.precision} float;
	precision ${i.precision} int;
	precision ${i.precision} sampler2D;
	precision ${i.precision} samplerCube;
	precision ${i.precision} sampler3D;
	precision ${i.precision} sampler2DArray;
	precision ${i.precision} sampler2DShadow;
	precision ${i.precision} samplerCubeShadow;
	precision ${i.precision} sampler2DArrayShadow;
	precision ${i.precision} isampler2D;
	precision ${i.precision} isampler3D;
	precision ${i.precision} isamplerCube;
	precision ${i.precision} isampler2DArray;
	precision ${i.precision} usampler2D;
	precision ${i.precision} usampler3D;
	precision ${i.precision} usamplerCube;
	precision ${i.precision} usampler2DArray;
	`;return i.precision==="highp"?e+=`
#define HIGH_PRECISION`:i.precision==="mediump"?e+=`
#define MEDIUM_PRECISION`:i.precision==="lowp"&&(e+=`
#define LOW_PRECISION`),e}function LN(i){let e="SHADOWMAP_TYPE_BASIC";return i.shadowMapType===em?e="SHADOWMAP_TYPE_PCF":i.shadowMapType===tm?e="SHADOWMAP_TYPE_PCF_SOFT":i.shadowMapType===Ui&&(e="SHADOWMAP_TYPE_VSM"),e}function NN(i){let e="ENVMAP_TYPE_CUBE";if(i.envMap)switch(i.envMapMode){case ko:case Fo:e="ENVMAP_TYPE_CUBE";break;case Ya:e="ENVMAP_TYPE_CUBE_UV";break}return e}function DN(i){let e="ENVMAP_MODE_REFLECTION";if(i.envMap)switch(i.envMapMode){case Fo:e="ENVMAP_MODE_REFRACTION";break}return e}function IN(i){let e="ENVMAP_BLENDING_NONE";if(i.envMap)switch(i.combine){case nm:e="ENVMAP_BLENDING_MULTIPLY";break;case kR:e="ENVMAP_BLENDING_MIX";break;case FR:e="ENVMAP_BLENDING_ADD";break}return e}function UN(i){const e=i.envMapCubeUVHeight;if(e===null)return null;const t=Math.log2(e)-2,n=1/e;return{texelWidth:1/(3*Math.max(Math.pow(2,t),112)),texelHeight:n,maxMip:t}}function kN(i,e,t,n){const s=i.getContext(),o=t.defines;let r=t.vertexShader,a=t.fragmentShader;const l=LN(t),c=NN(t),h=DN(t),u=IN(t),d=UN(t),m=SN(t),g=wN(o),_=s.createProgram();let p,f,M=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(p=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,g].filter(mr).join(`
`),p.length>0&&(p+=`
`),f=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,g].filter(mr).join(`
`),f.length>0&&(f+=`
`)):(p=[Mf(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,g,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+h:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGDEPTHBUF":"",t.reverseDepthBuffer?"#define USE_REVERSEDEPTHBUF":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(mr).join(`
`),f=[Mf(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,g,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+h:"",t.envMap?"#define "+u:"",d?"#define CUBEUV_TEXEL_WIDTH "+d.texelWidth:"",d?"#define CUBEUV_TEXEL_HEIGHT "+d.texelHeight:"",d?"#define CUBEUV_MAX_MIP "+d.maxMip+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor||t.batchingColor?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGDEPTHBUF":"",t.reverseDepthBuffer?"#define USE_REVERSEDEPTHBUF":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==hs?"#define TONE_MAPPING":"",t.toneMapping!==hs?it.tonemapping_pars_fragment:"",t.toneMapping!==hs?yN("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",it.colorspace_pars_fragment,bN("linearToOutputTexel",t.outputColorSpace),MN(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(mr).join(`
`)),r=eh(r),r=xf(r,t),r=bf(r,t),a=eh(a),a=xf(a,t),a=bf(a,t),r=yf(r),a=yf(a),t.isRawShaderMaterial!==!0&&(M=`#version 300 es
`,p=[m,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+p,f=["#define varying in",t.glslVersion===Id?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===Id?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+f);const S=M+p+r,x=M+f+a,F=gf(s,s.VERTEX_SHADER,S),P=gf(s,s.FRAGMENT_SHADER,x);s.attachShader(_,F),s.attachShader(_,P),t.index0AttributeName!==void 0?s.bindAttribLocation(_,0,t.index0AttributeName):t.morphTargets===!0&&s.bindAttribLocation(_,0,"position"),s.linkProgram(_);function A(R){if(i.debug.checkShaderErrors){const V=s.getProgramInfoLog(_).trim(),O=s.getShaderInfoLog(F).trim(),$=s.getShaderInfoLog(P).trim();let q=!0,X=!0;if(s.getProgramParameter(_,s.LINK_STATUS)===!1)if(q=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,_,F,P);else{const Y=vf(s,F,"vertex"),te=vf(s,P,"fragment");console.error("THREE.WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(_,s.VALIDATE_STATUS)+`

Material Name: `+R.name+`
Material Type: `+R.type+`

Program Info Log: `+V+`
`+Y+`
`+te)}else V!==""?console.warn("THREE.WebGLProgram: Program Info Log:",V):(O===""||$==="")&&(X=!1);X&&(R.diagnostics={runnable:q,programLog:V,vertexShader:{log:O,prefix:p},fragmentShader:{log:$,prefix:f}})}s.deleteShader(F),s.deleteShader(P),I=new Ea(s,_),E=EN(s,_)}let I;this.getUniforms=function(){return I===void 0&&A(this),I};let E;this.getAttributes=function(){return E===void 0&&A(this),E};let y=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return y===!1&&(y=s.getProgramParameter(_,gN)),y},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(_),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=_N++,this.cacheKey=e,this.usedTimes=1,this.program=_,this.vertexShader=F,this.fragmentShader=P,this}let FN=0;class ON{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e){const t=e.vertexShader,n=e.fragmentShader,s=this._getShaderStage(t),o=this._getShaderStage(n),r=this._getShaderCacheForMaterial(e);return r.has(s)===!1&&(r.add(s),s.usedTimes++),r.has(o)===!1&&(r.add(o),o.usedTimes++),this}remove(e){const t=this.materialCache.get(e);for(const n of t)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(e),this}getVertexShaderID(e){return this._getShaderStage(e.vertexShader).id}getFragmentShaderID(e){return this._getShaderStage(e.fragmentShader).id}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){const t=this.materialCache;let n=t.get(e);return n===void 0&&(n=new Set,t.set(e,n)),n}_getShaderStage(e){const t=this.shaderCache;let n=t.get(e);return n===void 0&&(n=new BN(e),t.set(e,n)),n}}class BN{constructor(e){this.id=FN++,this.code=e,this.usedTimes=0}}function zN(i,e,t,n,s,o,r){const a=new Oh,l=new ON,c=new Set,h=[],u=s.logarithmicDepthBuffer,d=s.vertexTextures;let m=s.precision;const g={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distanceRGBA",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function _(E){return c.add(E),E===0?"uv":`uv${E}`}function p(E,y,R,V,O){const $=V.fog,q=O.geometry,X=E.isMeshStandardMaterial?V.environment:null,Y=(E.isMeshStandardMaterial?t:e).get(E.envMap||X),te=Y&&Y.mapping===Ya?Y.image.height:null,le=g[E.type];E.precision!==null&&(m=s.getMaxPrecision(E.precision),m!==E.precision&&console.warn("THREE.WebGLProgram.getParameters:",E.precision,"not supported, using",m,"instead."));const he=q.morphAttributes.position||q.morphAttributes.normal||q.morphAttributes.color,_e=he!==void 0?he.length:0;let Me=0;q.morphAttributes.position!==void 0&&(Me=1),q.morphAttributes.normal!==void 0&&(Me=2),q.morphAttributes.color!==void 0&&(Me=3);let ge,oe,ue,ve;if(le){const yt=vi[le];ge=yt.vertexShader,oe=yt.fragmentShader}else ge=E.vertexShader,oe=E.fragmentShader,l.update(E),ue=l.getVertexShaderID(E),ve=l.getFragmentShaderID(E);const ce=i.getRenderTarget(),He=i.state.buffers.depth.getReversed(),Ge=O.isInstancedMesh===!0,ke=O.isBatchedMesh===!0,ct=!!E.map,Ze=!!E.matcap,ht=!!Y,G=!!E.aoMap,Yt=!!E.lightMap,et=!!E.bumpMap,nt=!!E.normalMap,We=!!E.displacementMap,ft=!!E.emissiveMap,Ne=!!E.metalnessMap,L=!!E.roughnessMap,w=E.anisotropy>0,Q=E.clearcoat>0,ne=E.dispersion>0,j=E.iridescence>0,ie=E.sheen>0,Se=E.transmission>0,xe=w&&!!E.anisotropyMap,Ae=Q&&!!E.clearcoatMap,Ke=Q&&!!E.clearcoatNormalMap,pe=Q&&!!E.clearcoatRoughnessMap,be=j&&!!E.iridescenceMap,Fe=j&&!!E.iridescenceThicknessMap,Be=ie&&!!E.sheenColorMap,Ee=ie&&!!E.sheenRoughnessMap,st=!!E.specularMap,je=!!E.specularColorMap,pt=!!E.specularIntensityMap,H=Se&&!!E.transmissionMap,ye=Se&&!!E.thicknessMap,se=!!E.gradientMap,ae=!!E.alphaMap,Re=E.alphaTest>0,Ce=!!E.alphaHash,Je=!!E.extensions;let Ft=hs;E.toneMapped&&(ce===null||ce.isXRRenderTarget===!0)&&(Ft=i.toneMapping);const nn={shaderID:le,shaderType:E.type,shaderName:E.name,vertexShader:ge,fragmentShader:oe,defines:E.defines,customVertexShaderID:ue,customFragmentShaderID:ve,isRawShaderMaterial:E.isRawShaderMaterial===!0,glslVersion:E.glslVersion,precision:m,batching:ke,batchingColor:ke&&O._colorsTexture!==null,instancing:Ge,instancingColor:Ge&&O.instanceColor!==null,instancingMorph:Ge&&O.morphTexture!==null,supportsVertexTextures:d,outputColorSpace:ce===null?i.outputColorSpace:ce.isXRRenderTarget===!0?ce.texture.colorSpace:qo,alphaToCoverage:!!E.alphaToCoverage,map:ct,matcap:Ze,envMap:ht,envMapMode:ht&&Y.mapping,envMapCubeUVHeight:te,aoMap:G,lightMap:Yt,bumpMap:et,normalMap:nt,displacementMap:d&&We,emissiveMap:ft,normalMapObjectSpace:nt&&E.normalMapType===jR,normalMapTangentSpace:nt&&E.normalMapType===pm,metalnessMap:Ne,roughnessMap:L,anisotropy:w,anisotropyMap:xe,clearcoat:Q,clearcoatMap:Ae,clearcoatNormalMap:Ke,clearcoatRoughnessMap:pe,dispersion:ne,iridescence:j,iridescenceMap:be,iridescenceThicknessMap:Fe,sheen:ie,sheenColorMap:Be,sheenRoughnessMap:Ee,specularMap:st,specularColorMap:je,specularIntensityMap:pt,transmission:Se,transmissionMap:H,thicknessMap:ye,gradientMap:se,opaque:E.transparent===!1&&E.blending===Ao&&E.alphaToCoverage===!1,alphaMap:ae,alphaTest:Re,alphaHash:Ce,combine:E.combine,mapUv:ct&&_(E.map.channel),aoMapUv:G&&_(E.aoMap.channel),lightMapUv:Yt&&_(E.lightMap.channel),bumpMapUv:et&&_(E.bumpMap.channel),normalMapUv:nt&&_(E.normalMap.channel),displacementMapUv:We&&_(E.displacementMap.channel),emissiveMapUv:ft&&_(E.emissiveMap.channel),metalnessMapUv:Ne&&_(E.metalnessMap.channel),roughnessMapUv:L&&_(E.roughnessMap.channel),anisotropyMapUv:xe&&_(E.anisotropyMap.channel),clearcoatMapUv:Ae&&_(E.clearcoatMap.channel),clearcoatNormalMapUv:Ke&&_(E.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:pe&&_(E.clearcoatRoughnessMap.channel),iridescenceMapUv:be&&_(E.iridescenceMap.channel),iridescenceThicknessMapUv:Fe&&_(E.iridescenceThicknessMap.channel),sheenColorMapUv:Be&&_(E.sheenColorMap.channel),sheenRoughnessMapUv:Ee&&_(E.sheenRoughnessMap.channel),specularMapUv:st&&_(E.specularMap.channel),specularColorMapUv:je&&_(E.specularColorMap.channel),specularIntensityMapUv:pt&&_(E.specularIntensityMap.channel),transmissionMapUv:H&&_(E.transmissionMap.channel),thicknessMapUv:ye&&_(E.thicknessMap.channel),alphaMapUv:ae&&_(E.alphaMap.channel),vertexTangents:!!q.attributes.tangent&&(nt||w),vertexColors:E.vertexColors,vertexAlphas:E.vertexColors===!0&&!!q.attributes.color&&q.attributes.color.itemSize===4,pointsUvs:O.isPoints===!0&&!!q.attributes.uv&&(ct||ae),fog:!!$,useFog:E.fog===!0,fogExp2:!!$&&$.isFogExp2,flatShading:E.flatShading===!0,sizeAttenuation:E.sizeAttenuation===!0,logarithmicDepthBuffer:u,reverseDepthBuffer:He,skinning:O.isSkinnedMesh===!0,morphTargets:q.morphAttributes.position!==void 0,morphNormals:q.morphAttributes.normal!==void 0,morphColors:q.morphAttributes.color!==void 0,morphTargetsCount:_e,morphTextureStride:Me,numDirLights:y.directional.length,numPointLights:y.point.length,numSpotLights:y.spot.length,numSpotLightMaps:y.spotLightMap.length,numRectAreaLights:y.rectArea.length,numHemiLights:y.hemi.length,numDirLightShadows:y.directionalShadowMap.length,numPointLightShadows:y.pointShadowMap.length,numSpotLightShadows:y.spotShadowMap.length,numSpotLightShadowsWithMaps:y.numSpotLightShadowsWithMaps,numLightProbes:y.numLightProbes,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:E.dithering,shadowMapEnabled:i.shadowMap.enabled&&R.length>0,shadowMapType:i.shadowMap.type,toneMapping:Ft,decodeVideoTexture:ct&&E.map.isVideoTexture===!0&&gt.getTransfer(E.map.colorSpace)===Rt,decodeVideoTextureEmissive:ft&&E.emissiveMap.isVideoTexture===!0&&gt.getTransfer(E.emissiveMap.colorSpace)===Rt,premultipliedAlpha:E.premultipliedAlpha,doubleSided:E.side===Fi,flipSided:E.side===Pn,useDepthPacking:E.depthPacking>=0,depthPacking:E.depthPacking||0,index0AttributeName:E.index0AttributeName,extensionClipCullDistance:Je&&E.extensions.clipCullDistance===!0&&n.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Je&&E.extensions.multiDraw===!0||ke)&&n.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:n.has("KHR_parallel_shader_compile"),customProgramCacheKey:E.customProgramCacheKey()};return nn.vertexUv1s=c.has(1),nn.vertexUv2s=c.has(2),nn.vertexUv3s=c.has(3),c.clear(),nn}function f(E){const y=[];if(E.shaderID?y.push(E.shaderID):(y.push(E.customVertexShaderID),y.push(E.customFragmentShaderID)),E.defines!==void 0)for(const R in E.defines)y.push(R),y.push(E.defines[R]);return E.isRawShaderMaterial===!1&&(M(y,E),S(y,E),y.push(i.outputColorSpace)),y.push(E.customProgramCacheKey),y.join()}function M(E,y){E.push(y.precision),E.push(y.outputColorSpace),E.push(y.envMapMode),E.push(y.envMapCubeUVHeight),E.push(y.mapUv),E.push(y.alphaMapUv),E.push(y.lightMapUv),E.push(y.aoMapUv),E.push(y.bumpMapUv),E.push(y.normalMapUv),E.push(y.displacementMapUv),E.push(y.emissiveMapUv),E.push(y.metalnessMapUv),E.push(y.roughnessMapUv),E.push(y.anisotropyMapUv),E.push(y.clearcoatMapUv),E.push(y.clearcoatNormalMapUv),E.push(y.clearcoatRoughnessMapUv),E.push(y.iridescenceMapUv),E.push(y.iridescenceThicknessMapUv),E.push(y.sheenColorMapUv),E.push(y.sheenRoughnessMapUv),E.push(y.specularMapUv),E.push(y.specularColorMapUv),E.push(y.specularIntensityMapUv),E.push(y.transmissionMapUv),E.push(y.thicknessMapUv),E.push(y.combine),E.push(y.fogExp2),E.push(y.sizeAttenuation),E.push(y.morphTargetsCount),E.push(y.morphAttributeCount),E.push(y.numDirLights),E.push(y.numPointLights),E.push(y.numSpotLights),E.push(y.numSpotLightMaps),E.push(y.numHemiLights),E.push(y.numRectAreaLights),E.push(y.numDirLightShadows),E.push(y.numPointLightShadows),E.push(y.numSpotLightShadows),E.push(y.numSpotLightShadowsWithMaps),E.push(y.numLightProbes),E.push(y.shadowMapType),E.push(y.toneMapping),E.push(y.numClippingPlanes),E.push(y.numClipIntersection),E.push(y.depthPacking)}function S(E,y){a.disableAll(),y.supportsVertexTextures&&a.enable(0),y.instancing&&a.enable(1),y.instancingColor&&a.enable(2),y.instancingMorph&&a.enable(3),y.matcap&&a.enable(4),y.envMap&&a.enable(5),y.normalMapObjectSpace&&a.enable(6),y.normalMapTangentSpace&&a.enable(7),y.clearcoat&&a.enable(8),y.iridescence&&a.enable(9),y.alphaTest&&a.enable(10),y.vertexColors&&a.enable(11),y.vertexAlphas&&a.enable(12),y.vertexUv1s&&a.enable(13),y.vertexUv2s&&a.enable(14),y.vertexUv3s&&a.enable(15),y.vertexTangents&&a.enable(16),y.anisotropy&&a.enable(17),y.alphaHash&&a.enable(18),y.batching&&a.enable(19),y.dispersion&&a.enable(20),y.batchingColor&&a.enable(21),E.push(a.mask),a.disableAll(),y.fog&&a.enable(0),y.useFog&&a.enable(1),y.flatShading&&a.enable(2),y.logarithmicDepthBuffer&&a.enable(3),y.reverseDepthBuffer&&a.enable(4),y.skinning&&a.enable(5),y.morphTargets&&a.enable(6),y.morphNormals&&a.enable(7),y.morphColors&&a.enable(8),y.premultipliedAlpha&&a.enable(9),y.shadowMapEnabled&&a.enable(10),y.doubleSided&&a.enable(11),y.flipSided&&a.enable(12),y.useDepthPacking&&a.enable(13),y.dithering&&a.enable(14),y.transmission&&a.enable(15),y.sheen&&a.enable(16),y.opaque&&a.enable(17),y.pointsUvs&&a.enable(18),y.decodeVideoTexture&&a.enable(19),y.decodeVideoTextureEmissive&&a.enable(20),y.alphaToCoverage&&a.enable(21),E.push(a.mask)}function x(E){const y=g[E.type];let R;if(y){const V=vi[y];R=SC.clone(V.uniforms)}else R=E.uniforms;return R}function F(E,y){let R;for(let V=0,O=h.length;V<O;V++){const $=h[V];if($.cacheKey===y){R=$,++R.usedTimes;break}}return R===void 0&&(R=new kN(i,y,E,o),h.push(R)),R}function P(E){if(--E.usedTimes===0){const y=h.indexOf(E);h[y]=h[h.length-1],h.pop(),E.destroy()}}function A(E){l.remove(E)}function I(){l.dispose()}return{getParameters:p,getProgramCacheKey:f,getUniforms:x,acquireProgram:F,releaseProgram:P,releaseShaderCache:A,programs:h,dispose:I}}function HN(){let i=new WeakMap;function e(r){return i.has(r)}function t(r){let a=i.get(r);return a===void 0&&(a={},i.set(r,a)),a}function n(r){i.delete(r)}function s(r,a,l){i.get(r)[a]=l}function o(){i=new WeakMap}return{has:e,get:t,remove:n,update:s,dispose:o}}function VN(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.material.id!==e.material.id?i.material.id-e.material.id:i.z!==e.z?i.z-e.z:i.id-e.id}function Sf(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.z!==e.z?e.z-i.z:i.id-e.id}function wf(){const i=[];let e=0;const t=[],n=[],s=[];function o(){e=0,t.length=0,n.length=0,s.length=0}function r(u,d,m,g,_,p){let f=i[e];return f===void 0?(f={id:u.id,object:u,geometry:d,material:m,groupOrder:g,renderOrder:u.renderOrder,z:_,group:p},i[e]=f):(f.id=u.id,f.object=u,f.geometry=d,f.material=m,f.groupOrder=g,f.renderOrder=u.renderOrder,f.z=_,f.group=p),e++,f}function a(u,d,m,g,_,p){const f=r(u,d,m,g,_,p);m.transmission>0?n.push(f):m.transparent===!0?s.push(f):t.push(f)}function l(u,d,m,g,_,p){const f=r(u,d,m,g,_,p);m.transmission>0?n.unshift(f):m.transparent===!0?s.unshift(f):t.unshift(f)}function c(u,d){t.length>1&&t.sort(u||VN),n.length>1&&n.sort(d||Sf),s.length>1&&s.sort(d||Sf)}function h(){for(let u=e,d=i.length;u<d;u++){const m=i[u];if(m.id===null)break;m.id=null,m.object=null,m.geometry=null,m.material=null,m.group=null}}return{opaque:t,transmissive:n,transparent:s,init:o,push:a,unshift:l,finish:h,sort:c}}function GN(){let i=new WeakMap;function e(n,s){const o=i.get(n);let r;return o===void 0?(r=new wf,i.set(n,[r])):s>=o.length?(r=new wf,o.push(r)):r=o[s],r}function t(){i=new WeakMap}return{get:e,dispose:t}}function WN(){const i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"DirectionalLight":t={direction:new ee,color:new dt};break;case"SpotLight":t={position:new ee,direction:new ee,color:new dt,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new ee,color:new dt,distance:0,decay:0};break;case"HemisphereLight":t={direction:new ee,skyColor:new dt,groundColor:new dt};break;case"RectAreaLight":t={color:new dt,position:new ee,halfWidth:new ee,halfHeight:new ee};break}return i[e.id]=t,t}}}function $N(){const i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new vt};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new vt};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new vt,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[e.id]=t,t}}}let qN=0;function XN(i,e){return(e.castShadow?2:0)-(i.castShadow?2:0)+(e.map?1:0)-(i.map?1:0)}function jN(i){const e=new WN,t=$N(),n={version:0,hash:{directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new ee);const s=new ee,o=new zt,r=new zt;function a(c){let h=0,u=0,d=0;for(let E=0;E<9;E++)n.probe[E].set(0,0,0);let m=0,g=0,_=0,p=0,f=0,M=0,S=0,x=0,F=0,P=0,A=0;c.sort(XN);for(let E=0,y=c.length;E<y;E++){const R=c[E],V=R.color,O=R.intensity,$=R.distance,q=R.shadow&&R.shadow.map?R.shadow.map.texture:null;if(R.isAmbientLight)h+=V.r*O,u+=V.g*O,d+=V.b*O;else if(R.isLightProbe){for(let X=0;X<9;X++)n.probe[X].addScaledVector(R.sh.coefficients[X],O);A++}else if(R.isDirectionalLight){const X=e.get(R);if(X.color.copy(R.color).multiplyScalar(R.intensity),R.castShadow){const Y=R.shadow,te=t.get(R);te.shadowIntensity=Y.intensity,te.shadowBias=Y.bias,te.shadowNormalBias=Y.normalBias,te.shadowRadius=Y.radius,te.shadowMapSize=Y.mapSize,n.directionalShadow[m]=te,n.directionalShadowMap[m]=q,n.directionalShadowMatrix[m]=R.shadow.matrix,M++}n.directional[m]=X,m++}else if(R.isSpotLight){const X=e.get(R);X.position.setFromMatrixPosition(R.matrixWorld),X.color.copy(V).multiplyScalar(O),X.distance=$,X.coneCos=Math.cos(R.angle),X.penumbraCos=Math.cos(R.angle*(1-R.penumbra)),X.decay=R.decay,n.spot[_]=X;const Y=R.shadow;if(R.map&&(n.spotLightMap[F]=R.map,F++,Y.updateMatrices(R),R.castShadow&&P++),n.spotLightMatrix[_]=Y.matrix,R.castShadow){const te=t.get(R);te.shadowIntensity=Y.intensity,te.shadowBias=Y.bias,te.shadowNormalBias=Y.normalBias,te.shadowRadius=Y.radius,te.shadowMapSize=Y.mapSize,n.spotShadow[_]=te,n.spotShadowMap[_]=q,x++}_++}else if(R.isRectAreaLight){const X=e.get(R);X.color.copy(V).multiplyScalar(O),X.halfWidth.set(R.width*.5,0,0),X.halfHeight.set(0,R.height*.5,0),n.rectArea[p]=X,p++}else if(R.isPointLight){const X=e.get(R);if(X.color.copy(R.color).multiplyScalar(R.intensity),X.distance=R.distance,X.decay=R.decay,R.castShadow){const Y=R.shadow,te=t.get(R);te.shadowIntensity=Y.intensity,te.shadowBias=Y.bias,te.shadowNormalBias=Y.normalBias,te.shadowRadius=Y.radius,te.shadowMapSize=Y.mapSize,te.shadowCameraNear=Y.camera.near,te.shadowCameraFar=Y.camera.far,n.pointShadow[g]=te,n.pointShadowMap[g]=q,n.pointShadowMatrix[g]=R.shadow.matrix,S++}n.point[g]=X,g++}else if(R.isHemisphereLight){const X=e.get(R);X.skyColor.copy(R.color).multiplyScalar(O),X.groundColor.copy(R.groundColor).multiplyScalar(O),n.hemi[f]=X,f++}}p>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=Te.LTC_FLOAT_1,n.rectAreaLTC2=Te.LTC_FLOAT_2):(n.rectAreaLTC1=Te.LTC_HALF_1,n.rectAreaLTC2=Te.LTC_HALF_2)),n.ambient[0]=h,n.ambient[1]=u,n.ambient[2]=d;const I=n.hash;(I.directionalLength!==m||I.pointLength!==g||I.spotLength!==_||I.rectAreaLength!==p||I.hemiLength!==f||I.numDirectionalShadows!==M||I.numPointShadows!==S||I.numSpotShadows!==x||I.numSpotMaps!==F||I.numLightProbes!==A)&&(n.directional.length=m,n.spot.length=_,n.rectArea.length=p,n.point.length=g,n.hemi.length=f,n.directionalShadow.length=M,n.directionalShadowMap.length=M,n.pointShadow.length=S,n.pointShadowMap.length=S,n.spotShadow.length=x,n.spotShadowMap.length=x,n.directionalShadowMatrix.length=M,n.pointShadowMatrix.length=S,n.spotLightMatrix.length=x+F-P,n.spotLightMap.length=F,n.numSpotLightShadowsWithMaps=P,n.numLightProbes=A,I.directionalLength=m,I.pointLength=g,I.spotLength=_,I.rectAreaLength=p,I.hemiLength=f,I.numDirectionalShadows=M,I.numPointShadows=S,I.numSpotShadows=x,I.numSpotMaps=F,I.numLightProbes=A,n.version=qN++)}function l(c,h){let u=0,d=0,m=0,g=0,_=0;const p=h.matrixWorldInverse;for(let f=0,M=c.length;f<M;f++){const S=c[f];if(S.isDirectionalLight){const x=n.directional[u];x.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),x.direction.sub(s),x.direction.transformDirection(p),u++}else if(S.isSpotLight){const x=n.spot[m];x.position.setFromMatrixPosition(S.matrixWorld),x.position.applyMatrix4(p),x.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),x.direction.sub(s),x.direction.transformDirection(p),m++}else if(S.isRectAreaLight){const x=n.rectArea[g];x.position.setFromMatrixPosition(S.matrixWorld),x.position.applyMatrix4(p),r.identity(),o.copy(S.matrixWorld),o.premultiply(p),r.extractRotation(o),x.halfWidth.set(S.width*.5,0,0),x.halfHeight.set(0,S.height*.5,0),x.halfWidth.applyMatrix4(r),x.halfHeight.applyMatrix4(r),g++}else if(S.isPointLight){const x=n.point[d];x.position.setFromMatrixPosition(S.matrixWorld),x.position.applyMatrix4(p),d++}else if(S.isHemisphereLight){const x=n.hemi[_];x.direction.setFromMatrixPosition(S.matrixWorld),x.direction.transformDirection(p),_++}}}return{setup:a,setupView:l,state:n}}function Ef(i){const e=new jN(i),t=[],n=[];function s(h){c.camera=h,t.length=0,n.length=0}function o(h){t.push(h)}function r(h){n.push(h)}function a(){e.setup(t)}function l(h){e.setupView(t,h)}const c={lightsArray:t,shadowsArray:n,camera:null,lights:e,transmissionRenderTarget:{}};return{init:s,state:c,setupLights:a,setupLightsView:l,pushLight:o,pushShadow:r}}function YN(i){let e=new WeakMap;function t(s,o=0){const r=e.get(s);let a;return r===void 0?(a=new Ef(i),e.set(s,[a])):o>=r.length?(a=new Ef(i),r.push(a)):a=r[o],a}function n(){e=new WeakMap}return{get:t,dispose:n}}class KN extends Lr{static get type(){return"MeshDepthMaterial"}constructor(e){super(),this.isMeshDepthMaterial=!0,this.depthPacking=qR,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}}class ZN extends Lr{static get type(){return"MeshDistanceMaterial"}constructor(e){super(),this.isMeshDistanceMaterial=!0,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}}const JN=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,QN=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
#include <packing>
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = unpackRGBATo2Half( texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ) );
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = unpackRGBAToDepth( texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ) );
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( squared_mean - mean * mean );
	gl_FragColor = pack2HalfToRGBA( vec2( mean, std_dev ) );
}`;function eD(i,e,t){let n=new zh;const s=new vt,o=new vt,r=new Gt,a=new KN({depthPacking:XR}),l=new ZN,c={},h=t.maxTextureSize,u={[ps]:Pn,[Pn]:ps,[Fi]:Fi},d=new ms({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new vt},radius:{value:4}},vertexShader:JN,fragmentShader:QN}),m=d.clone();m.defines.HORIZONTAL_PASS=1;const g=new gs;g.setAttribute("position",new Mi(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));const _=new un(g,d),p=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=em;let f=this.type;this.render=function(P,A,I){if(p.enabled===!1||p.autoUpdate===!1&&p.needsUpdate===!1||P.length===0)return;const E=i.getRenderTarget(),y=i.getActiveCubeFace(),R=i.getActiveMipmapLevel(),V=i.state;V.setBlending(cs),V.buffers.color.setClear(1,1,1,1),V.buffers.depth.setTest(!0),V.setScissorTest(!1);const O=f!==Ui&&this.type===Ui,$=f===Ui&&this.type!==Ui;for(let q=0,X=P.length;q<X;q++){const Y=P[q],te=Y.shadow;if(te===void 0){console.warn("THREE.WebGLShadowMap:",Y,"has no shadow.");continue}if(te.autoUpdate===!1&&te.needsUpdate===!1)continue;s.copy(te.mapSize);const le=te.getFrameExtents();if(s.multiply(le),o.copy(te.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(o.x=Math.floor(h/le.x),s.x=o.x*le.x,te.mapSize.x=o.x),s.y>h&&(o.y=Math.floor(h/le.y),s.y=o.y*le.y,te.mapSize.y=o.y)),te.map===null||O===!0||$===!0){const _e=this.type!==Ui?{minFilter:ci,magFilter:ci}:{};te.map!==null&&te.map.dispose(),te.map=new Ws(s.x,s.y,_e),te.map.texture.name=Y.name+".shadowMap",te.camera.updateProjectionMatrix()}i.setRenderTarget(te.map),i.clear();const he=te.getViewportCount();for(let _e=0;_e<he;_e++){const Me=te.getViewport(_e);r.set(o.x*Me.x,o.y*Me.y,o.x*Me.z,o.y*Me.w),V.viewport(r),te.updateMatrices(Y,_e),n=te.getFrustum(),x(A,I,te.camera,Y,this.type)}te.isPointLightShadow!==!0&&this.type===Ui&&M(te,I),te.needsUpdate=!1}f=this.type,p.needsUpdate=!1,i.setRenderTarget(E,y,R)};function M(P,A){const I=e.update(_);d.defines.VSM_SAMPLES!==P.blurSamples&&(d.defines.VSM_SAMPLES=P.blurSamples,m.defines.VSM_SAMPLES=P.blurSamples,d.needsUpdate=!0,m.needsUpdate=!0),P.mapPass===null&&(P.mapPass=new Ws(s.x,s.y)),d.uniforms.shadow_pass.value=P.map.texture,d.uniforms.resolution.value=P.mapSize,d.uniforms.radius.value=P.radius,i.setRenderTarget(P.mapPass),i.clear(),i.renderBufferDirect(A,null,I,d,_,null),m.uniforms.shadow_pass.value=P.mapPass.texture,m.uniforms.resolution.value=P.mapSize,m.uniforms.radius.value=P.radius,i.setRenderTarget(P.map),i.clear(),i.renderBufferDirect(A,null,I,m,_,null)}function S(P,A,I,E){let y=null;const R=I.isPointLight===!0?P.customDistanceMaterial:P.customDepthMaterial;if(R!==void 0)y=R;else if(y=I.isPointLight===!0?l:a,i.localClippingEnabled&&A.clipShadows===!0&&Array.isArray(A.clippingPlanes)&&A.clippingPlanes.length!==0||A.displacementMap&&A.displacementScale!==0||A.alphaMap&&A.alphaTest>0||A.map&&A.alphaTest>0){const V=y.uuid,O=A.uuid;let $=c[V];$===void 0&&($={},c[V]=$);let q=$[O];q===void 0&&(q=y.clone(),$[O]=q,A.addEventListener("dispose",F)),y=q}if(y.visible=A.visible,y.wireframe=A.wireframe,E===Ui?y.side=A.shadowSide!==null?A.shadowSide:A.side:y.side=A.shadowSide!==null?A.shadowSide:u[A.side],y.alphaMap=A.alphaMap,y.alphaTest=A.alphaTest,y.map=A.map,y.clipShadows=A.clipShadows,y.clippingPlanes=A.clippingPlanes,y.clipIntersection=A.clipIntersection,y.displacementMap=A.displacementMap,y.displacementScale=A.displacementScale,y.displacementBias=A.displacementBias,y.wireframeLinewidth=A.wireframeLinewidth,y.linewidth=A.linewidth,I.isPointLight===!0&&y.isMeshDistanceMaterial===!0){const V=i.properties.get(y);V.light=I}return y}function x(P,A,I,E,y){if(P.visible===!1)return;if(P.layers.test(A.layers)&&(P.isMesh||P.isLine||P.isPoints)&&(P.castShadow||P.receiveShadow&&y===Ui)&&(!P.frustumCulled||n.intersectsObject(P))){P.modelViewMatrix.multiplyMatrices(I.matrixWorldInverse,P.matrixWorld);const O=e.update(P),$=P.material;if(Array.isArray($)){const q=O.groups;for(let X=0,Y=q.length;X<Y;X++){const te=q[X],le=$[te.materialIndex];if(le&&le.visible){const he=S(P,le,E,y);P.onBeforeShadow(i,P,A,I,O,he,te),i.renderBufferDirect(I,null,O,he,P,te),P.onAfterShadow(i,P,A,I,O,he,te)}}}else if($.visible){const q=S(P,$,E,y);P.onBeforeShadow(i,P,A,I,O,q,null),i.renderBufferDirect(I,null,O,q,P,null),P.onAfterShadow(i,P,A,I,O,q,null)}}const V=P.children;for(let O=0,$=V.length;O<$;O++)x(V[O],A,I,E,y)}function F(P){P.target.removeEventListener("dispose",F);for(const I in c){const E=c[I],y=P.target.uuid;y in E&&(E[y].dispose(),delete E[y])}}}const tD={[_c]:vc,[xc]:Mc,[bc]:Sc,[Uo]:yc,[vc]:_c,[Mc]:xc,[Sc]:bc,[yc]:Uo};function nD(i,e){function t(){let H=!1;const ye=new Gt;let se=null;const ae=new Gt(0,0,0,0);return{setMask:function(Re){se!==Re&&!H&&(i.colorMask(Re,Re,Re,Re),se=Re)},setLocked:function(Re){H=Re},setClear:function(Re,Ce,Je,Ft,nn){nn===!0&&(Re*=Ft,Ce*=Ft,Je*=Ft),ye.set(Re,Ce,Je,Ft),ae.equals(ye)===!1&&(i.clearColor(Re,Ce,Je,Ft),ae.copy(ye))},reset:function(){H=!1,se=null,ae.set(-1,0,0,0)}}}function n(){let H=!1,ye=!1,se=null,ae=null,Re=null;return{setReversed:function(Ce){if(ye!==Ce){const Je=e.get("EXT_clip_control");ye?Je.clipControlEXT(Je.LOWER_LEFT_EXT,Je.ZERO_TO_ONE_EXT):Je.clipControlEXT(Je.LOWER_LEFT_EXT,Je.NEGATIVE_ONE_TO_ONE_EXT);const Ft=Re;Re=null,this.setClear(Ft)}ye=Ce},getReversed:function(){return ye},setTest:function(Ce){Ce?ce(i.DEPTH_TEST):He(i.DEPTH_TEST)},setMask:function(Ce){se!==Ce&&!H&&(i.depthMask(Ce),se=Ce)},setFunc:function(Ce){if(ye&&(Ce=tD[Ce]),ae!==Ce){switch(Ce){case _c:i.depthFunc(i.NEVER);break;case vc:i.depthFunc(i.ALWAYS);break;case xc:i.depthFunc(i.LESS);break;case Uo:i.depthFunc(i.LEQUAL);break;case bc:i.depthFunc(i.EQUAL);break;case yc:i.depthFunc(i.GEQUAL);break;case Mc:i.depthFunc(i.GREATER);break;case Sc:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}ae=Ce}},setLocked:function(Ce){H=Ce},setClear:function(Ce){Re!==Ce&&(ye&&(Ce=1-Ce),i.clearDepth(Ce),Re=Ce)},reset:function(){H=!1,se=null,ae=null,Re=null,ye=!1}}}function s(){let H=!1,ye=null,se=null,ae=null,Re=null,Ce=null,Je=null,Ft=null,nn=null;return{setTest:function(yt){H||(yt?ce(i.STENCIL_TEST):He(i.STENCIL_TEST))},setMask:function(yt){ye!==yt&&!H&&(i.stencilMask(yt),ye=yt)},setFunc:function(yt,Kt,Nt){(se!==yt||ae!==Kt||Re!==Nt)&&(i.stencilFunc(yt,Kt,Nt),se=yt,ae=Kt,Re=Nt)},setOp:function(yt,Kt,Nt){(Ce!==yt||Je!==Kt||Ft!==Nt)&&(i.stencilOp(yt,Kt,Nt),Ce=yt,Je=Kt,Ft=Nt)},setLocked:function(yt){H=yt},setClear:function(yt){nn!==yt&&(i.clearStencil(yt),nn=yt)},reset:function(){H=!1,ye=null,se=null,ae=null,Re=null,Ce=null,Je=null,Ft=null,nn=null}}}const o=new t,r=new n,a=new s,l=new WeakMap,c=new WeakMap;let h={},u={},d=new WeakMap,m=[],g=null,_=!1,p=null,f=null,M=null,S=null,x=null,F=null,P=null,A=new dt(0,0,0),I=0,E=!1,y=null,R=null,V=null,O=null,$=null;const q=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS);let X=!1,Y=0;const te=i.getParameter(i.VERSION);te.indexOf("WebGL")!==-1?(Y=parseFloat(/^WebGL (\d)/.exec(te)[1]),X=Y>=1):te.indexOf("OpenGL ES")!==-1&&(Y=parseFloat(/^OpenGL ES (\d)/.exec(te)[1]),X=Y>=2);let le=null,he={};const _e=i.getParameter(i.SCISSOR_BOX),Me=i.getParameter(i.VIEWPORT),ge=new Gt().fromArray(_e),oe=new Gt().fromArray(Me);function ue(H,ye,se,ae){const Re=new Uint8Array(4),Ce=i.createTexture();i.bindTexture(H,Ce),i.texParameteri(H,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(H,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let Je=0;Je<se;Je++)H===i.TEXTURE_3D||H===i.TEXTURE_2D_ARRAY?i.texImage3D(ye,0,i.RGBA,1,1,ae,0,i.RGBA,i.UNSIGNED_BYTE,Re):i.texImage2D(ye+Je,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,Re);return Ce}const ve={};ve[i.TEXTURE_2D]=ue(i.TEXTURE_2D,i.TEXTURE_2D,1),ve[i.TEXTURE_CUBE_MAP]=ue(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),ve[i.TEXTURE_2D_ARRAY]=ue(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),ve[i.TEXTURE_3D]=ue(i.TEXTURE_3D,i.TEXTURE_3D,1,1),o.setClear(0,0,0,1),r.setClear(1),a.setClear(0),ce(i.DEPTH_TEST),r.setFunc(Uo),et(!1),nt(Rd),ce(i.CULL_FACE),G(cs);function ce(H){h[H]!==!0&&(i.enable(H),h[H]=!0)}function He(H){h[H]!==!1&&(i.disable(H),h[H]=!1)}function Ge(H,ye){return u[H]!==ye?(i.bindFramebuffer(H,ye),u[H]=ye,H===i.DRAW_FRAMEBUFFER&&(u[i.FRAMEBUFFER]=ye),H===i.FRAMEBUFFER&&(u[i.DRAW_FRAMEBUFFER]=ye),!0):!1}function ke(H,ye){let se=m,ae=!1;if(H){se=d.get(ye),se===void 0&&(se=[],d.set(ye,se));const Re=H.textures;if(se.length!==Re.length||se[0]!==i.COLOR_ATTACHMENT0){for(let Ce=0,Je=Re.length;Ce<Je;Ce++)se[Ce]=i.COLOR_ATTACHMENT0+Ce;se.length=Re.length,ae=!0}}else se[0]!==i.BACK&&(se[0]=i.BACK,ae=!0);ae&&i.drawBuffers(se)}function ct(H){return g!==H?(i.useProgram(H),g=H,!0):!1}const Ze={[Us]:i.FUNC_ADD,[xR]:i.FUNC_SUBTRACT,[bR]:i.FUNC_REVERSE_SUBTRACT};Ze[yR]=i.MIN,Ze[MR]=i.MAX;const ht={[SR]:i.ZERO,[wR]:i.ONE,[ER]:i.SRC_COLOR,[mc]:i.SRC_ALPHA,[LR]:i.SRC_ALPHA_SATURATE,[CR]:i.DST_COLOR,[AR]:i.DST_ALPHA,[TR]:i.ONE_MINUS_SRC_COLOR,[gc]:i.ONE_MINUS_SRC_ALPHA,[PR]:i.ONE_MINUS_DST_COLOR,[RR]:i.ONE_MINUS_DST_ALPHA,[NR]:i.CONSTANT_COLOR,[DR]:i.ONE_MINUS_CONSTANT_COLOR,[IR]:i.CONSTANT_ALPHA,[UR]:i.ONE_MINUS_CONSTANT_ALPHA};function G(H,ye,se,ae,Re,Ce,Je,Ft,nn,yt){if(H===cs){_===!0&&(He(i.BLEND),_=!1);return}if(_===!1&&(ce(i.BLEND),_=!0),H!==vR){if(H!==p||yt!==E){if((f!==Us||x!==Us)&&(i.blendEquation(i.FUNC_ADD),f=Us,x=Us),yt)switch(H){case Ao:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Cd:i.blendFunc(i.ONE,i.ONE);break;case Pd:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case Ld:i.blendFuncSeparate(i.ZERO,i.SRC_COLOR,i.ZERO,i.SRC_ALPHA);break;default:console.error("THREE.WebGLState: Invalid blending: ",H);break}else switch(H){case Ao:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Cd:i.blendFunc(i.SRC_ALPHA,i.ONE);break;case Pd:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case Ld:i.blendFunc(i.ZERO,i.SRC_COLOR);break;default:console.error("THREE.WebGLState: Invalid blending: ",H);break}M=null,S=null,F=null,P=null,A.set(0,0,0),I=0,p=H,E=yt}return}Re=Re||ye,Ce=Ce||se,Je=Je||ae,(ye!==f||Re!==x)&&(i.blendEquationSeparate(Ze[ye],Ze[Re]),f=ye,x=Re),(se!==M||ae!==S||Ce!==F||Je!==P)&&(i.blendFuncSeparate(ht[se],ht[ae],ht[Ce],ht[Je]),M=se,S=ae,F=Ce,P=Je),(Ft.equals(A)===!1||nn!==I)&&(i.blendColor(Ft.r,Ft.g,Ft.b,nn),A.copy(Ft),I=nn),p=H,E=!1}function Yt(H,ye){H.side===Fi?He(i.CULL_FACE):ce(i.CULL_FACE);let se=H.side===Pn;ye&&(se=!se),et(se),H.blending===Ao&&H.transparent===!1?G(cs):G(H.blending,H.blendEquation,H.blendSrc,H.blendDst,H.blendEquationAlpha,H.blendSrcAlpha,H.blendDstAlpha,H.blendColor,H.blendAlpha,H.premultipliedAlpha),r.setFunc(H.depthFunc),r.setTest(H.depthTest),r.setMask(H.depthWrite),o.setMask(H.colorWrite);const ae=H.stencilWrite;a.setTest(ae),ae&&(a.setMask(H.stencilWriteMask),a.setFunc(H.stencilFunc,H.stencilRef,H.stencilFuncMask),a.setOp(H.stencilFail,H.stencilZFail,H.stencilZPass)),ft(H.polygonOffset,H.polygonOffsetFactor,H.polygonOffsetUnits),H.alphaToCoverage===!0?ce(i.SAMPLE_ALPHA_TO_COVERAGE):He(i.SAMPLE_ALPHA_TO_COVERAGE)}function et(H){y!==H&&(H?i.frontFace(i.CW):i.frontFace(i.CCW),y=H)}function nt(H){H!==gR?(ce(i.CULL_FACE),H!==R&&(H===Rd?i.cullFace(i.BACK):H===_R?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):He(i.CULL_FACE),R=H}function We(H){H!==V&&(X&&i.lineWidth(H),V=H)}function ft(H,ye,se){H?(ce(i.POLYGON_OFFSET_FILL),(O!==ye||$!==se)&&(i.polygonOffset(ye,se),O=ye,$=se)):He(i.POLYGON_OFFSET_FILL)}function Ne(H){H?ce(i.SCISSOR_TEST):He(i.SCISSOR_TEST)}function L(H){H===void 0&&(H=i.TEXTURE0+q-1),le!==H&&(i.activeTexture(H),le=H)}function w(H,ye,se){se===void 0&&(le===null?se=i.TEXTURE0+q-1:se=le);let ae=he[se];ae===void 0&&(ae={type:void 0,texture:void 0},he[se]=ae),(ae.type!==H||ae.texture!==ye)&&(le!==se&&(i.activeTexture(se),le=se),i.bindTexture(H,ye||ve[H]),ae.type=H,ae.texture=ye)}function Q(){const H=he[le];H!==void 0&&H.type!==void 0&&(i.bindTexture(H.type,null),H.type=void 0,H.texture=void 0)}function ne(){try{i.compressedTexImage2D.apply(i,arguments)}catch(H){console.error("THREE.WebGLState:",H)}}function j(){try{i.compressedTexImage3D.apply(i,arguments)}catch(H){console.error("THREE.WebGLState:",H)}}function ie(){try{i.texSubImage2D.apply(i,arguments)}catch(H){console.error("THREE.WebGLState:",H)}}function Se(){try{i.texSubImage3D.apply(i,arguments)}catch(H){console.error("THREE.WebGLState:",H)}}function xe(){try{i.compressedTexSubImage2D.apply(i,arguments)}catch(H){console.error("THREE.WebGLState:",H)}}function Ae(){try{i.compressedTexSubImage3D.apply(i,arguments)}catch(H){console.error("THREE.WebGLState:",H)}}function Ke(){try{i.texStorage2D.apply(i,arguments)}catch(H){console.error("THREE.WebGLState:",H)}}function pe(){try{i.texStorage3D.apply(i,arguments)}catch(H){console.error("THREE.WebGLState:",H)}}function be(){try{i.texImage2D.apply(i,arguments)}catch(H){console.error("THREE.WebGLState:",H)}}function Fe(){try{i.texImage3D.apply(i,arguments)}catch(H){console.error("THREE.WebGLState:",H)}}function Be(H){ge.equals(H)===!1&&(i.scissor(H.x,H.y,H.z,H.w),ge.copy(H))}function Ee(H){oe.equals(H)===!1&&(i.viewport(H.x,H.y,H.z,H.w),oe.copy(H))}function st(H,ye){let se=c.get(ye);se===void 0&&(se=new WeakMap,c.set(ye,se));let ae=se.get(H);ae===void 0&&(ae=i.getUniformBlockIndex(ye,H.name),se.set(H,ae))}function je(H,ye){const ae=c.get(ye).get(H);l.get(ye)!==ae&&(i.uniformBlockBinding(ye,ae,H.__bindingPointIndex),l.set(ye,ae))}function pt(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),r.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),h={},le=null,he={},u={},d=new WeakMap,m=[],g=null,_=!1,p=null,f=null,M=null,S=null,x=null,F=null,P=null,A=new dt(0,0,0),I=0,E=!1,y=null,R=null,V=null,O=null,$=null,ge.set(0,0,i.canvas.width,i.canvas.height),oe.set(0,0,i.canvas.width,i.canvas.height),o.reset(),r.reset(),a.reset()}return{buffers:{color:o,depth:r,stencil:a},enable:ce,disable:He,bindFramebuffer:Ge,drawBuffers:ke,useProgram:ct,setBlending:G,setMaterial:Yt,setFlipSided:et,setCullFace:nt,setLineWidth:We,setPolygonOffset:ft,setScissorTest:Ne,activeTexture:L,bindTexture:w,unbindTexture:Q,compressedTexImage2D:ne,compressedTexImage3D:j,texImage2D:be,texImage3D:Fe,updateUBOMapping:st,uniformBlockBinding:je,texStorage2D:Ke,texStorage3D:pe,texSubImage2D:ie,texSubImage3D:Se,compressedTexSubImage2D:xe,compressedTexSubImage3D:Ae,scissor:Be,viewport:Ee,reset:pt}}function Tf(i,e,t,n){const s=iD(n);switch(t){case am:return i*e;case cm:return i*e;case hm:return i*e*2;case um:return i*e/s.components*s.byteLength;case Ih:return i*e/s.components*s.byteLength;case dm:return i*e*2/s.components*s.byteLength;case Uh:return i*e*2/s.components*s.byteLength;case lm:return i*e*3/s.components*s.byteLength;case li:return i*e*4/s.components*s.byteLength;case kh:return i*e*4/s.components*s.byteLength;case ba:case ya:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case Ma:case Sa:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Rc:case Pc:return Math.max(i,16)*Math.max(e,8)/4;case Ac:case Cc:return Math.max(i,8)*Math.max(e,8)/2;case Lc:case Nc:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case Dc:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Ic:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Uc:return Math.floor((i+4)/5)*Math.floor((e+3)/4)*16;case kc:return Math.floor((i+4)/5)*Math.floor((e+4)/5)*16;case Fc:return Math.floor((i+5)/6)*Math.floor((e+4)/5)*16;case Oc:return Math.floor((i+5)/6)*Math.floor((e+5)/6)*16;case Bc:return Math.floor((i+7)/8)*Math.floor((e+4)/5)*16;case zc:return Math.floor((i+7)/8)*Math.floor((e+5)/6)*16;case Hc:return Math.floor((i+7)/8)*Math.floor((e+7)/8)*16;case Vc:return Math.floor((i+9)/10)*Math.floor((e+4)/5)*16;case Gc:return Math.floor((i+9)/10)*Math.floor((e+5)/6)*16;case Wc:return Math.floor((i+9)/10)*Math.floor((e+7)/8)*16;case $c:return Math.floor((i+9)/10)*Math.floor((e+9)/10)*16;case qc:return Math.floor((i+11)/12)*Math.floor((e+9)/10)*16;case Xc:return Math.floor((i+11)/12)*Math.floor((e+11)/12)*16;case wa:case jc:case Yc:return Math.ceil(i/4)*Math.ceil(e/4)*16;case fm:case Kc:return Math.ceil(i/4)*Math.ceil(e/4)*8;case Zc:case Jc:return Math.ceil(i/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function iD(i){switch(i){case $i:case sm:return{byteLength:1,components:1};case wr:case om:case Ar:return{byteLength:2,components:1};case Nh:case Dh:return{byteLength:2,components:4};case Gs:case Lh:case Oi:return{byteLength:4,components:1};case rm:return{byteLength:4,components:3}}throw new Error(`Unknown texture type ${i}.`)}function sD(i,e,t,n,s,o,r){const a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new vt,h=new WeakMap;let u;const d=new WeakMap;let m=!1;try{m=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function g(L,w){return m?new OffscreenCanvas(L,w):ka("canvas")}function _(L,w,Q){let ne=1;const j=Ne(L);if((j.width>Q||j.height>Q)&&(ne=Q/Math.max(j.width,j.height)),ne<1)if(typeof HTMLImageElement<"u"&&L instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&L instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&L instanceof ImageBitmap||typeof VideoFrame<"u"&&L instanceof VideoFrame){const ie=Math.floor(ne*j.width),Se=Math.floor(ne*j.height);u===void 0&&(u=g(ie,Se));const xe=w?g(ie,Se):u;return xe.width=ie,xe.height=Se,xe.getContext("2d").drawImage(L,0,0,ie,Se),console.warn("THREE.WebGLRenderer: Texture has been resized from ("+j.width+"x"+j.height+") to ("+ie+"x"+Se+")."),xe}else return"data"in L&&console.warn("THREE.WebGLRenderer: Image in DataTexture is too big ("+j.width+"x"+j.height+")."),L;return L}function p(L){return L.generateMipmaps}function f(L){i.generateMipmap(L)}function M(L){return L.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:L.isWebGL3DRenderTarget?i.TEXTURE_3D:L.isWebGLArrayRenderTarget||L.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function S(L,w,Q,ne,j=!1){if(L!==null){if(i[L]!==void 0)return i[L];console.warn("THREE.WebGLRenderer: Attempt to use non-existing WebGL internal format '"+L+"'")}let ie=w;if(w===i.RED&&(Q===i.FLOAT&&(ie=i.R32F),Q===i.HALF_FLOAT&&(ie=i.R16F),Q===i.UNSIGNED_BYTE&&(ie=i.R8)),w===i.RED_INTEGER&&(Q===i.UNSIGNED_BYTE&&(ie=i.R8UI),Q===i.UNSIGNED_SHORT&&(ie=i.R16UI),Q===i.UNSIGNED_INT&&(ie=i.R32UI),Q===i.BYTE&&(ie=i.R8I),Q===i.SHORT&&(ie=i.R16I),Q===i.INT&&(ie=i.R32I)),w===i.RG&&(Q===i.FLOAT&&(ie=i.RG32F),Q===i.HALF_FLOAT&&(ie=i.RG16F),Q===i.UNSIGNED_BYTE&&(ie=i.RG8)),w===i.RG_INTEGER&&(Q===i.UNSIGNED_BYTE&&(ie=i.RG8UI),Q===i.UNSIGNED_SHORT&&(ie=i.RG16UI),Q===i.UNSIGNED_INT&&(ie=i.RG32UI),Q===i.BYTE&&(ie=i.RG8I),Q===i.SHORT&&(ie=i.RG16I),Q===i.INT&&(ie=i.RG32I)),w===i.RGB_INTEGER&&(Q===i.UNSIGNED_BYTE&&(ie=i.RGB8UI),Q===i.UNSIGNED_SHORT&&(ie=i.RGB16UI),Q===i.UNSIGNED_INT&&(ie=i.RGB32UI),Q===i.BYTE&&(ie=i.RGB8I),Q===i.SHORT&&(ie=i.RGB16I),Q===i.INT&&(ie=i.RGB32I)),w===i.RGBA_INTEGER&&(Q===i.UNSIGNED_BYTE&&(ie=i.RGBA8UI),Q===i.UNSIGNED_SHORT&&(ie=i.RGBA16UI),Q===i.UNSIGNED_INT&&(ie=i.RGBA32UI),Q===i.BYTE&&(ie=i.RGBA8I),Q===i.SHORT&&(ie=i.RGBA16I),Q===i.INT&&(ie=i.RGBA32I)),w===i.RGB&&Q===i.UNSIGNED_INT_5_9_9_9_REV&&(ie=i.RGB9_E5),w===i.RGBA){const Se=j?Ka:gt.getTransfer(ne);Q===i.FLOAT&&(ie=i.RGBA32F),Q===i.HALF_FLOAT&&(ie=i.RGBA16F),Q===i.UNSIGNED_BYTE&&(ie=Se===Rt?i.SRGB8_ALPHA8:i.RGBA8),Q===i.UNSIGNED_SHORT_4_4_4_4&&(ie=i.RGBA4),Q===i.UNSIGNED_SHORT_5_5_5_1&&(ie=i.RGB5_A1)}return(ie===i.R16F||ie===i.R32F||ie===i.RG16F||ie===i.RG32F||ie===i.RGBA16F||ie===i.RGBA32F)&&e.get("EXT_color_buffer_float"),ie}function x(L,w){let Q;return L?w===null||w===Gs||w===Oo?Q=i.DEPTH24_STENCIL8:w===Oi?Q=i.DEPTH32F_STENCIL8:w===wr&&(Q=i.DEPTH24_STENCIL8,console.warn("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):w===null||w===Gs||w===Oo?Q=i.DEPTH_COMPONENT24:w===Oi?Q=i.DEPTH_COMPONENT32F:w===wr&&(Q=i.DEPTH_COMPONENT16),Q}function F(L,w){return p(L)===!0||L.isFramebufferTexture&&L.minFilter!==ci&&L.minFilter!==bi?Math.log2(Math.max(w.width,w.height))+1:L.mipmaps!==void 0&&L.mipmaps.length>0?L.mipmaps.length:L.isCompressedTexture&&Array.isArray(L.image)?w.mipmaps.length:1}function P(L){const w=L.target;w.removeEventListener("dispose",P),I(w),w.isVideoTexture&&h.delete(w)}function A(L){const w=L.target;w.removeEventListener("dispose",A),y(w)}function I(L){const w=n.get(L);if(w.__webglInit===void 0)return;const Q=L.source,ne=d.get(Q);if(ne){const j=ne[w.__cacheKey];j.usedTimes--,j.usedTimes===0&&E(L),Object.keys(ne).length===0&&d.delete(Q)}n.remove(L)}function E(L){const w=n.get(L);i.deleteTexture(w.__webglTexture);const Q=L.source,ne=d.get(Q);delete ne[w.__cacheKey],r.memory.textures--}function y(L){const w=n.get(L);if(L.depthTexture&&(L.depthTexture.dispose(),n.remove(L.depthTexture)),L.isWebGLCubeRenderTarget)for(let ne=0;ne<6;ne++){if(Array.isArray(w.__webglFramebuffer[ne]))for(let j=0;j<w.__webglFramebuffer[ne].length;j++)i.deleteFramebuffer(w.__webglFramebuffer[ne][j]);else i.deleteFramebuffer(w.__webglFramebuffer[ne]);w.__webglDepthbuffer&&i.deleteRenderbuffer(w.__webglDepthbuffer[ne])}else{if(Array.isArray(w.__webglFramebuffer))for(let ne=0;ne<w.__webglFramebuffer.length;ne++)i.deleteFramebuffer(w.__webglFramebuffer[ne]);else i.deleteFramebuffer(w.__webglFramebuffer);if(w.__webglDepthbuffer&&i.deleteRenderbuffer(w.__webglDepthbuffer),w.__webglMultisampledFramebuffer&&i.deleteFramebuffer(w.__webglMultisampledFramebuffer),w.__webglColorRenderbuffer)for(let ne=0;ne<w.__webglColorRenderbuffer.length;ne++)w.__webglColorRenderbuffer[ne]&&i.deleteRenderbuffer(w.__webglColorRenderbuffer[ne]);w.__webglDepthRenderbuffer&&i.deleteRenderbuffer(w.__webglDepthRenderbuffer)}const Q=L.textures;for(let ne=0,j=Q.length;ne<j;ne++){const ie=n.get(Q[ne]);ie.__webglTexture&&(i.deleteTexture(ie.__webglTexture),r.memory.textures--),n.remove(Q[ne])}n.remove(L)}let R=0;function V(){R=0}function O(){const L=R;return L>=s.maxTextures&&console.warn("THREE.WebGLTextures: Trying to use "+L+" texture units while this GPU supports only "+s.maxTextures),R+=1,L}function $(L){const w=[];return w.push(L.wrapS),w.push(L.wrapT),w.push(L.wrapR||0),w.push(L.magFilter),w.push(L.minFilter),w.push(L.anisotropy),w.push(L.internalFormat),w.push(L.format),w.push(L.type),w.push(L.generateMipmaps),w.push(L.premultiplyAlpha),w.push(L.flipY),w.push(L.unpackAlignment),w.push(L.colorSpace),w.join()}function q(L,w){const Q=n.get(L);if(L.isVideoTexture&&We(L),L.isRenderTargetTexture===!1&&L.version>0&&Q.__version!==L.version){const ne=L.image;if(ne===null)console.warn("THREE.WebGLRenderer: Texture marked for update but no image data found.");else if(ne.complete===!1)console.warn("THREE.WebGLRenderer: Texture marked for update but image is incomplete");else{oe(Q,L,w);return}}t.bindTexture(i.TEXTURE_2D,Q.__webglTexture,i.TEXTURE0+w)}function X(L,w){const Q=n.get(L);if(L.version>0&&Q.__version!==L.version){oe(Q,L,w);return}t.bindTexture(i.TEXTURE_2D_ARRAY,Q.__webglTexture,i.TEXTURE0+w)}function Y(L,w){const Q=n.get(L);if(L.version>0&&Q.__version!==L.version){oe(Q,L,w);return}t.bindTexture(i.TEXTURE_3D,Q.__webglTexture,i.TEXTURE0+w)}function te(L,w){const Q=n.get(L);if(L.version>0&&Q.__version!==L.version){ue(Q,L,w);return}t.bindTexture(i.TEXTURE_CUBE_MAP,Q.__webglTexture,i.TEXTURE0+w)}const le={[Ia]:i.REPEAT,[Fs]:i.CLAMP_TO_EDGE,[Tc]:i.MIRRORED_REPEAT},he={[ci]:i.NEAREST,[$R]:i.NEAREST_MIPMAP_NEAREST,[Xr]:i.NEAREST_MIPMAP_LINEAR,[bi]:i.LINEAR,[Ml]:i.LINEAR_MIPMAP_NEAREST,[Os]:i.LINEAR_MIPMAP_LINEAR},_e={[YR]:i.NEVER,[tC]:i.ALWAYS,[KR]:i.LESS,[mm]:i.LEQUAL,[ZR]:i.EQUAL,[eC]:i.GEQUAL,[JR]:i.GREATER,[QR]:i.NOTEQUAL};function Me(L,w){if(w.type===Oi&&e.has("OES_texture_float_linear")===!1&&(w.magFilter===bi||w.magFilter===Ml||w.magFilter===Xr||w.magFilter===Os||w.minFilter===bi||w.minFilter===Ml||w.minFilter===Xr||w.minFilter===Os)&&console.warn("THREE.WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(L,i.TEXTURE_WRAP_S,le[w.wrapS]),i.texParameteri(L,i.TEXTURE_WRAP_T,le[w.wrapT]),(L===i.TEXTURE_3D||L===i.TEXTURE_2D_ARRAY)&&i.texParameteri(L,i.TEXTURE_WRAP_R,le[w.wrapR]),i.texParameteri(L,i.TEXTURE_MAG_FILTER,he[w.magFilter]),i.texParameteri(L,i.TEXTURE_MIN_FILTER,he[w.minFilter]),w.compareFunction&&(i.texParameteri(L,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(L,i.TEXTURE_COMPARE_FUNC,_e[w.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(w.magFilter===ci||w.minFilter!==Xr&&w.minFilter!==Os||w.type===Oi&&e.has("OES_texture_float_linear")===!1)return;if(w.anisotropy>1||n.get(w).__currentAnisotropy){const Q=e.get("EXT_texture_filter_anisotropic");i.texParameterf(L,Q.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(w.anisotropy,s.getMaxAnisotropy())),n.get(w).__currentAnisotropy=w.anisotropy}}}function ge(L,w){let Q=!1;L.__webglInit===void 0&&(L.__webglInit=!0,w.addEventListener("dispose",P));const ne=w.source;let j=d.get(ne);j===void 0&&(j={},d.set(ne,j));const ie=$(w);if(ie!==L.__cacheKey){j[ie]===void 0&&(j[ie]={texture:i.createTexture(),usedTimes:0},r.memory.textures++,Q=!0),j[ie].usedTimes++;const Se=j[L.__cacheKey];Se!==void 0&&(j[L.__cacheKey].usedTimes--,Se.usedTimes===0&&E(w)),L.__cacheKey=ie,L.__webglTexture=j[ie].texture}return Q}function oe(L,w,Q){let ne=i.TEXTURE_2D;(w.isDataArrayTexture||w.isCompressedArrayTexture)&&(ne=i.TEXTURE_2D_ARRAY),w.isData3DTexture&&(ne=i.TEXTURE_3D);const j=ge(L,w),ie=w.source;t.bindTexture(ne,L.__webglTexture,i.TEXTURE0+Q);const Se=n.get(ie);if(ie.version!==Se.__version||j===!0){t.activeTexture(i.TEXTURE0+Q);const xe=gt.getPrimaries(gt.workingColorSpace),Ae=w.colorSpace===as?null:gt.getPrimaries(w.colorSpace),Ke=w.colorSpace===as||xe===Ae?i.NONE:i.BROWSER_DEFAULT_WEBGL;i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,w.flipY),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,w.premultiplyAlpha),i.pixelStorei(i.UNPACK_ALIGNMENT,w.unpackAlignment),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,Ke);let pe=_(w.image,!1,s.maxTextureSize);pe=ft(w,pe);const be=o.convert(w.format,w.colorSpace),Fe=o.convert(w.type);let Be=S(w.internalFormat,be,Fe,w.colorSpace,w.isVideoTexture);Me(ne,w);let Ee;const st=w.mipmaps,je=w.isVideoTexture!==!0,pt=Se.__version===void 0||j===!0,H=ie.dataReady,ye=F(w,pe);if(w.isDepthTexture)Be=x(w.format===Bo,w.type),pt&&(je?t.texStorage2D(i.TEXTURE_2D,1,Be,pe.width,pe.height):t.texImage2D(i.TEXTURE_2D,0,Be,pe.width,pe.height,0,be,Fe,null));else if(w.isDataTexture)if(st.length>0){je&&pt&&t.texStorage2D(i.TEXTURE_2D,ye,Be,st[0].width,st[0].height);for(let se=0,ae=st.length;se<ae;se++)Ee=st[se],je?H&&t.texSubImage2D(i.TEXTURE_2D,se,0,0,Ee.width,Ee.height,be,Fe,Ee.data):t.texImage2D(i.TEXTURE_2D,se,Be,Ee.width,Ee.height,0,be,Fe,Ee.data);w.generateMipmaps=!1}else je?(pt&&t.texStorage2D(i.TEXTURE_2D,ye,Be,pe.width,pe.height),H&&t.texSubImage2D(i.TEXTURE_2D,0,0,0,pe.width,pe.height,be,Fe,pe.data)):t.texImage2D(i.TEXTURE_2D,0,Be,pe.width,pe.height,0,be,Fe,pe.data);else if(w.isCompressedTexture)if(w.isCompressedArrayTexture){je&&pt&&t.texStorage3D(i.TEXTURE_2D_ARRAY,ye,Be,st[0].width,st[0].height,pe.depth);for(let se=0,ae=st.length;se<ae;se++)if(Ee=st[se],w.format!==li)if(be!==null)if(je){if(H)if(w.layerUpdates.size>0){const Re=Tf(Ee.width,Ee.height,w.format,w.type);for(const Ce of w.layerUpdates){const Je=Ee.data.subarray(Ce*Re/Ee.data.BYTES_PER_ELEMENT,(Ce+1)*Re/Ee.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,se,0,0,Ce,Ee.width,Ee.height,1,be,Je)}w.clearLayerUpdates()}else t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,se,0,0,0,Ee.width,Ee.height,pe.depth,be,Ee.data)}else t.compressedTexImage3D(i.TEXTURE_2D_ARRAY,se,Be,Ee.width,Ee.height,pe.depth,0,Ee.data,0,0);else console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else je?H&&t.texSubImage3D(i.TEXTURE_2D_ARRAY,se,0,0,0,Ee.width,Ee.height,pe.depth,be,Fe,Ee.data):t.texImage3D(i.TEXTURE_2D_ARRAY,se,Be,Ee.width,Ee.height,pe.depth,0,be,Fe,Ee.data)}else{je&&pt&&t.texStorage2D(i.TEXTURE_2D,ye,Be,st[0].width,st[0].height);for(let se=0,ae=st.length;se<ae;se++)Ee=st[se],w.format!==li?be!==null?je?H&&t.compressedTexSubImage2D(i.TEXTURE_2D,se,0,0,Ee.width,Ee.height,be,Ee.data):t.compressedTexImage2D(i.TEXTURE_2D,se,Be,Ee.width,Ee.height,0,Ee.data):console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):je?H&&t.texSubImage2D(i.TEXTURE_2D,se,0,0,Ee.width,Ee.height,be,Fe,Ee.data):t.texImage2D(i.TEXTURE_2D,se,Be,Ee.width,Ee.height,0,be,Fe,Ee.data)}else if(w.isDataArrayTexture)if(je){if(pt&&t.texStorage3D(i.TEXTURE_2D_ARRAY,ye,Be,pe.width,pe.height,pe.depth),H)if(w.layerUpdates.size>0){const se=Tf(pe.width,pe.height,w.format,w.type);for(const ae of w.layerUpdates){const Re=pe.data.subarray(ae*se/pe.data.BYTES_PER_ELEMENT,(ae+1)*se/pe.data.BYTES_PER_ELEMENT);t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,ae,pe.width,pe.height,1,be,Fe,Re)}w.clearLayerUpdates()}else t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,pe.width,pe.height,pe.depth,be,Fe,pe.data)}else t.texImage3D(i.TEXTURE_2D_ARRAY,0,Be,pe.width,pe.height,pe.depth,0,be,Fe,pe.data);else if(w.isData3DTexture)je?(pt&&t.texStorage3D(i.TEXTURE_3D,ye,Be,pe.width,pe.height,pe.depth),H&&t.texSubImage3D(i.TEXTURE_3D,0,0,0,0,pe.width,pe.height,pe.depth,be,Fe,pe.data)):t.texImage3D(i.TEXTURE_3D,0,Be,pe.width,pe.height,pe.depth,0,be,Fe,pe.data);else if(w.isFramebufferTexture){if(pt)if(je)t.texStorage2D(i.TEXTURE_2D,ye,Be,pe.width,pe.height);else{let se=pe.width,ae=pe.height;for(let Re=0;Re<ye;Re++)t.texImage2D(i.TEXTURE_2D,Re,Be,se,ae,0,be,Fe,null),se>>=1,ae>>=1}}else if(st.length>0){if(je&&pt){const se=Ne(st[0]);t.texStorage2D(i.TEXTURE_2D,ye,Be,se.width,se.height)}for(let se=0,ae=st.length;se<ae;se++)Ee=st[se],je?H&&t.texSubImage2D(i.TEXTURE_2D,se,0,0,be,Fe,Ee):t.texImage2D(i.TEXTURE_2D,se,Be,be,Fe,Ee);w.generateMipmaps=!1}else if(je){if(pt){const se=Ne(pe);t.texStorage2D(i.TEXTURE_2D,ye,Be,se.width,se.height)}H&&t.texSubImage2D(i.TEXTURE_2D,0,0,0,be,Fe,pe)}else t.texImage2D(i.TEXTURE_2D,0,Be,be,Fe,pe);p(w)&&f(ne),Se.__version=ie.version,w.onUpdate&&w.onUpdate(w)}L.__version=w.version}function ue(L,w,Q){if(w.image.length!==6)return;const ne=ge(L,w),j=w.source;t.bindTexture(i.TEXTURE_CUBE_MAP,L.__webglTexture,i.TEXTURE0+Q);const ie=n.get(j);if(j.version!==ie.__version||ne===!0){t.activeTexture(i.TEXTURE0+Q);const Se=gt.getPrimaries(gt.workingColorSpace),xe=w.colorSpace===as?null:gt.getPrimaries(w.colorSpace),Ae=w.colorSpace===as||Se===xe?i.NONE:i.BROWSER_DEFAULT_WEBGL;i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,w.flipY),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,w.premultiplyAlpha),i.pixelStorei(i.UNPACK_ALIGNMENT,w.unpackAlignment),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,Ae);const Ke=w.isCompressedTexture||w.image[0].isCompressedTexture,pe=w.image[0]&&w.image[0].isDataTexture,be=[];for(let ae=0;ae<6;ae++)!Ke&&!pe?be[ae]=_(w.image[ae],!0,s.maxCubemapSize):be[ae]=pe?w.image[ae].image:w.image[ae],be[ae]=ft(w,be[ae]);const Fe=be[0],Be=o.convert(w.format,w.colorSpace),Ee=o.convert(w.type),st=S(w.internalFormat,Be,Ee,w.colorSpace),je=w.isVideoTexture!==!0,pt=ie.__version===void 0||ne===!0,H=j.dataReady;let ye=F(w,Fe);Me(i.TEXTURE_CUBE_MAP,w);let se;if(Ke){je&&pt&&t.texStorage2D(i.TEXTURE_CUBE_MAP,ye,st,Fe.width,Fe.height);for(let ae=0;ae<6;ae++){se=be[ae].mipmaps;for(let Re=0;Re<se.length;Re++){const Ce=se[Re];w.format!==li?Be!==null?je?H&&t.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ae,Re,0,0,Ce.width,Ce.height,Be,Ce.data):t.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ae,Re,st,Ce.width,Ce.height,0,Ce.data):console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):je?H&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ae,Re,0,0,Ce.width,Ce.height,Be,Ee,Ce.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ae,Re,st,Ce.width,Ce.height,0,Be,Ee,Ce.data)}}}else{if(se=w.mipmaps,je&&pt){se.length>0&&ye++;const ae=Ne(be[0]);t.texStorage2D(i.TEXTURE_CUBE_MAP,ye,st,ae.width,ae.height)}for(let ae=0;ae<6;ae++)if(pe){je?H&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ae,0,0,0,be[ae].width,be[ae].height,Be,Ee,be[ae].data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ae,0,st,be[ae].width,be[ae].height,0,Be,Ee,be[ae].data);for(let Re=0;Re<se.length;Re++){const Je=se[Re].image[ae].image;je?H&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ae,Re+1,0,0,Je.width,Je.height,Be,Ee,Je.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ae,Re+1,st,Je.width,Je.height,0,Be,Ee,Je.data)}}else{je?H&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ae,0,0,0,Be,Ee,be[ae]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ae,0,st,Be,Ee,be[ae]);for(let Re=0;Re<se.length;Re++){const Ce=se[Re];je?H&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ae,Re+1,0,0,Be,Ee,Ce.image[ae]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ae,Re+1,st,Be,Ee,Ce.image[ae])}}}p(w)&&f(i.TEXTURE_CUBE_MAP),ie.__version=j.version,w.onUpdate&&w.onUpdate(w)}L.__version=w.version}function ve(L,w,Q,ne,j,ie){const Se=o.convert(Q.format,Q.colorSpace),xe=o.convert(Q.type),Ae=S(Q.internalFormat,Se,xe,Q.colorSpace),Ke=n.get(w),pe=n.get(Q);if(pe.__renderTarget=w,!Ke.__hasExternalTextures){const be=Math.max(1,w.width>>ie),Fe=Math.max(1,w.height>>ie);j===i.TEXTURE_3D||j===i.TEXTURE_2D_ARRAY?t.texImage3D(j,ie,Ae,be,Fe,w.depth,0,Se,xe,null):t.texImage2D(j,ie,Ae,be,Fe,0,Se,xe,null)}t.bindFramebuffer(i.FRAMEBUFFER,L),nt(w)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,ne,j,pe.__webglTexture,0,et(w)):(j===i.TEXTURE_2D||j>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&j<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,ne,j,pe.__webglTexture,ie),t.bindFramebuffer(i.FRAMEBUFFER,null)}function ce(L,w,Q){if(i.bindRenderbuffer(i.RENDERBUFFER,L),w.depthBuffer){const ne=w.depthTexture,j=ne&&ne.isDepthTexture?ne.type:null,ie=x(w.stencilBuffer,j),Se=w.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,xe=et(w);nt(w)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,xe,ie,w.width,w.height):Q?i.renderbufferStorageMultisample(i.RENDERBUFFER,xe,ie,w.width,w.height):i.renderbufferStorage(i.RENDERBUFFER,ie,w.width,w.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,Se,i.RENDERBUFFER,L)}else{const ne=w.textures;for(let j=0;j<ne.length;j++){const ie=ne[j],Se=o.convert(ie.format,ie.colorSpace),xe=o.convert(ie.type),Ae=S(ie.internalFormat,Se,xe,ie.colorSpace),Ke=et(w);Q&&nt(w)===!1?i.renderbufferStorageMultisample(i.RENDERBUFFER,Ke,Ae,w.width,w.height):nt(w)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,Ke,Ae,w.width,w.height):i.renderbufferStorage(i.RENDERBUFFER,Ae,w.width,w.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function He(L,w){if(w&&w.isWebGLCubeRenderTarget)throw new Error("Depth Texture with cube render targets is not supported");if(t.bindFramebuffer(i.FRAMEBUFFER,L),!(w.depthTexture&&w.depthTexture.isDepthTexture))throw new Error("renderTarget.depthTexture must be an instance of THREE.DepthTexture");const ne=n.get(w.depthTexture);ne.__renderTarget=w,(!ne.__webglTexture||w.depthTexture.image.width!==w.width||w.depthTexture.image.height!==w.height)&&(w.depthTexture.image.width=w.width,w.depthTexture.image.height=w.height,w.depthTexture.needsUpdate=!0),q(w.depthTexture,0);const j=ne.__webglTexture,ie=et(w);if(w.depthTexture.format===Ro)nt(w)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,i.DEPTH_ATTACHMENT,i.TEXTURE_2D,j,0,ie):i.framebufferTexture2D(i.FRAMEBUFFER,i.DEPTH_ATTACHMENT,i.TEXTURE_2D,j,0);else if(w.depthTexture.format===Bo)nt(w)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,i.DEPTH_STENCIL_ATTACHMENT,i.TEXTURE_2D,j,0,ie):i.framebufferTexture2D(i.FRAMEBUFFER,i.DEPTH_STENCIL_ATTACHMENT,i.TEXTURE_2D,j,0);else throw new Error("Unknown depthTexture format")}function Ge(L){const w=n.get(L),Q=L.isWebGLCubeRenderTarget===!0;if(w.__boundDepthTexture!==L.depthTexture){const ne=L.depthTexture;if(w.__depthDisposeCallback&&w.__depthDisposeCallback(),ne){const j=()=>{delete w.__boundDepthTexture,delete w.__depthDisposeCallback,ne.removeEventListener("dispose",j)};ne.addEventListener("dispose",j),w.__depthDisposeCallback=j}w.__boundDepthTexture=ne}if(L.depthTexture&&!w.__autoAllocateDepthBuffer){if(Q)throw new Error("target.depthTexture not supported in Cube render targets");He(w.__webglFramebuffer,L)}else if(Q){w.__webglDepthbuffer=[];for(let ne=0;ne<6;ne++)if(t.bindFramebuffer(i.FRAMEBUFFER,w.__webglFramebuffer[ne]),w.__webglDepthbuffer[ne]===void 0)w.__webglDepthbuffer[ne]=i.createRenderbuffer(),ce(w.__webglDepthbuffer[ne],L,!1);else{const j=L.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ie=w.__webglDepthbuffer[ne];i.bindRenderbuffer(i.RENDERBUFFER,ie),i.framebufferRenderbuffer(i.FRAMEBUFFER,j,i.RENDERBUFFER,ie)}}else if(t.bindFramebuffer(i.FRAMEBUFFER,w.__webglFramebuffer),w.__webglDepthbuffer===void 0)w.__webglDepthbuffer=i.createRenderbuffer(),ce(w.__webglDepthbuffer,L,!1);else{const ne=L.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,j=w.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,j),i.framebufferRenderbuffer(i.FRAMEBUFFER,ne,i.RENDERBUFFER,j)}t.bindFramebuffer(i.FRAMEBUFFER,null)}function ke(L,w,Q){const ne=n.get(L);w!==void 0&&ve(ne.__webglFramebuffer,L,L.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),Q!==void 0&&Ge(L)}function ct(L){const w=L.texture,Q=n.get(L),ne=n.get(w);L.addEventListener("dispose",A);const j=L.textures,ie=L.isWebGLCubeRenderTarget===!0,Se=j.length>1;if(Se||(ne.__webglTexture===void 0&&(ne.__webglTexture=i.createTexture()),ne.__version=w.version,r.memory.textures++),ie){Q.__webglFramebuffer=[];for(let xe=0;xe<6;xe++)if(w.mipmaps&&w.mipmaps.length>0){Q.__webglFramebuffer[xe]=[];for(let Ae=0;Ae<w.mipmaps.length;Ae++)Q.__webglFramebuffer[xe][Ae]=i.createFramebuffer()}else Q.__webglFramebuffer[xe]=i.createFramebuffer()}else{if(w.mipmaps&&w.mipmaps.length>0){Q.__webglFramebuffer=[];for(let xe=0;xe<w.mipmaps.length;xe++)Q.__webglFramebuffer[xe]=i.createFramebuffer()}else Q.__webglFramebuffer=i.createFramebuffer();if(Se)for(let xe=0,Ae=j.length;xe<Ae;xe++){const Ke=n.get(j[xe]);Ke.__webglTexture===void 0&&(Ke.__webglTexture=i.createTexture(),r.memory.textures++)}if(L.samples>0&&nt(L)===!1){Q.__webglMultisampledFramebuffer=i.createFramebuffer(),Q.__webglColorRenderbuffer=[],t.bindFramebuffer(i.FRAMEBUFFER,Q.__webglMultisampledFramebuffer);for(let xe=0;xe<j.length;xe++){const Ae=j[xe];Q.__webglColorRenderbuffer[xe]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,Q.__webglColorRenderbuffer[xe]);const Ke=o.convert(Ae.format,Ae.colorSpace),pe=o.convert(Ae.type),be=S(Ae.internalFormat,Ke,pe,Ae.colorSpace,L.isXRRenderTarget===!0),Fe=et(L);i.renderbufferStorageMultisample(i.RENDERBUFFER,Fe,be,L.width,L.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+xe,i.RENDERBUFFER,Q.__webglColorRenderbuffer[xe])}i.bindRenderbuffer(i.RENDERBUFFER,null),L.depthBuffer&&(Q.__webglDepthRenderbuffer=i.createRenderbuffer(),ce(Q.__webglDepthRenderbuffer,L,!0)),t.bindFramebuffer(i.FRAMEBUFFER,null)}}if(ie){t.bindTexture(i.TEXTURE_CUBE_MAP,ne.__webglTexture),Me(i.TEXTURE_CUBE_MAP,w);for(let xe=0;xe<6;xe++)if(w.mipmaps&&w.mipmaps.length>0)for(let Ae=0;Ae<w.mipmaps.length;Ae++)ve(Q.__webglFramebuffer[xe][Ae],L,w,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+xe,Ae);else ve(Q.__webglFramebuffer[xe],L,w,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+xe,0);p(w)&&f(i.TEXTURE_CUBE_MAP),t.unbindTexture()}else if(Se){for(let xe=0,Ae=j.length;xe<Ae;xe++){const Ke=j[xe],pe=n.get(Ke);t.bindTexture(i.TEXTURE_2D,pe.__webglTexture),Me(i.TEXTURE_2D,Ke),ve(Q.__webglFramebuffer,L,Ke,i.COLOR_ATTACHMENT0+xe,i.TEXTURE_2D,0),p(Ke)&&f(i.TEXTURE_2D)}t.unbindTexture()}else{let xe=i.TEXTURE_2D;if((L.isWebGL3DRenderTarget||L.isWebGLArrayRenderTarget)&&(xe=L.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(xe,ne.__webglTexture),Me(xe,w),w.mipmaps&&w.mipmaps.length>0)for(let Ae=0;Ae<w.mipmaps.length;Ae++)ve(Q.__webglFramebuffer[Ae],L,w,i.COLOR_ATTACHMENT0,xe,Ae);else ve(Q.__webglFramebuffer,L,w,i.COLOR_ATTACHMENT0,xe,0);p(w)&&f(xe),t.unbindTexture()}L.depthBuffer&&Ge(L)}function Ze(L){const w=L.textures;for(let Q=0,ne=w.length;Q<ne;Q++){const j=w[Q];if(p(j)){const ie=M(L),Se=n.get(j).__webglTexture;t.bindTexture(ie,Se),f(ie),t.unbindTexture()}}}const ht=[],G=[];function Yt(L){if(L.samples>0){if(nt(L)===!1){const w=L.textures,Q=L.width,ne=L.height;let j=i.COLOR_BUFFER_BIT;const ie=L.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,Se=n.get(L),xe=w.length>1;if(xe)for(let Ae=0;Ae<w.length;Ae++)t.bindFramebuffer(i.FRAMEBUFFER,Se.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+Ae,i.RENDERBUFFER,null),t.bindFramebuffer(i.FRAMEBUFFER,Se.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+Ae,i.TEXTURE_2D,null,0);t.bindFramebuffer(i.READ_FRAMEBUFFER,Se.__webglMultisampledFramebuffer),t.bindFramebuffer(i.DRAW_FRAMEBUFFER,Se.__webglFramebuffer);for(let Ae=0;Ae<w.length;Ae++){if(L.resolveDepthBuffer&&(L.depthBuffer&&(j|=i.DEPTH_BUFFER_BIT),L.stencilBuffer&&L.resolveStencilBuffer&&(j|=i.STENCIL_BUFFER_BIT)),xe){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,Se.__webglColorRenderbuffer[Ae]);const Ke=n.get(w[Ae]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,Ke,0)}i.blitFramebuffer(0,0,Q,ne,0,0,Q,ne,j,i.NEAREST),l===!0&&(ht.length=0,G.length=0,ht.push(i.COLOR_ATTACHMENT0+Ae),L.depthBuffer&&L.resolveDepthBuffer===!1&&(ht.push(ie),G.push(ie),i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,G)),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,ht))}if(t.bindFramebuffer(i.READ_FRAMEBUFFER,null),t.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),xe)for(let Ae=0;Ae<w.length;Ae++){t.bindFramebuffer(i.FRAMEBUFFER,Se.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+Ae,i.RENDERBUFFER,Se.__webglColorRenderbuffer[Ae]);const Ke=n.get(w[Ae]).__webglTexture;t.bindFramebuffer(i.FRAMEBUFFER,Se.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+Ae,i.TEXTURE_2D,Ke,0)}t.bindFramebuffer(i.DRAW_FRAMEBUFFER,Se.__webglMultisampledFramebuffer)}else if(L.depthBuffer&&L.resolveDepthBuffer===!1&&l){const w=L.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[w])}}}function et(L){return Math.min(s.maxSamples,L.samples)}function nt(L){const w=n.get(L);return L.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&w.__useRenderToTexture!==!1}function We(L){const w=r.render.frame;h.get(L)!==w&&(h.set(L,w),L.update())}function ft(L,w){const Q=L.colorSpace,ne=L.format,j=L.type;return L.isCompressedTexture===!0||L.isVideoTexture===!0||Q!==qo&&Q!==as&&(gt.getTransfer(Q)===Rt?(ne!==li||j!==$i)&&console.warn("THREE.WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):console.error("THREE.WebGLTextures: Unsupported texture color space:",Q)),w}function Ne(L){return typeof HTMLImageElement<"u"&&L instanceof HTMLImageElement?(c.width=L.naturalWidth||L.width,c.height=L.naturalHeight||L.height):typeof VideoFrame<"u"&&L instanceof VideoFrame?(c.width=L.displayWidth,c.height=L.displayHeight):(c.width=L.width,c.height=L.height),c}this.allocateTextureUnit=O,this.resetTextureUnits=V,this.setTexture2D=q,this.setTexture2DArray=X,this.setTexture3D=Y,this.setTextureCube=te,this.rebindTextures=ke,this.setupRenderTarget=ct,this.updateRenderTargetMipmap=Ze,this.updateMultisampleRenderTarget=Yt,this.setupDepthRenderbuffer=Ge,this.setupFrameBufferTexture=ve,this.useMultisampledRTT=nt}function oD(i,e){function t(n,s=as){let o;const r=gt.getTransfer(s);if(n===$i)return i.UNSIGNED_BYTE;if(n===Nh)return i.UNSIGNED_SHORT_4_4_4_4;if(n===Dh)return i.UNSIGNED_SHORT_5_5_5_1;if(n===rm)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===sm)return i.BYTE;if(n===om)return i.SHORT;if(n===wr)return i.UNSIGNED_SHORT;if(n===Lh)return i.INT;if(n===Gs)return i.UNSIGNED_INT;if(n===Oi)return i.FLOAT;if(n===Ar)return i.HALF_FLOAT;if(n===am)return i.ALPHA;if(n===lm)return i.RGB;if(n===li)return i.RGBA;if(n===cm)return i.LUMINANCE;if(n===hm)return i.LUMINANCE_ALPHA;if(n===Ro)return i.DEPTH_COMPONENT;if(n===Bo)return i.DEPTH_STENCIL;if(n===um)return i.RED;if(n===Ih)return i.RED_INTEGER;if(n===dm)return i.RG;if(n===Uh)return i.RG_INTEGER;if(n===kh)return i.RGBA_INTEGER;if(n===ba||n===ya||n===Ma||n===Sa)if(r===Rt)if(o=e.get("WEBGL_compressed_texture_s3tc_srgb"),o!==null){if(n===ba)return o.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===ya)return o.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===Ma)return o.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===Sa)return o.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(o=e.get("WEBGL_compressed_texture_s3tc"),o!==null){if(n===ba)return o.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===ya)return o.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===Ma)return o.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===Sa)return o.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===Ac||n===Rc||n===Cc||n===Pc)if(o=e.get("WEBGL_compressed_texture_pvrtc"),o!==null){if(n===Ac)return o.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===Rc)return o.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===Cc)return o.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===Pc)return o.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===Lc||n===Nc||n===Dc)if(o=e.get("WEBGL_compressed_texture_etc"),o!==null){if(n===Lc||n===Nc)return r===Rt?o.COMPRESSED_SRGB8_ETC2:o.COMPRESSED_RGB8_ETC2;if(n===Dc)return r===Rt?o.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:o.COMPRESSED_RGBA8_ETC2_EAC}else return null;if(n===Ic||n===Uc||n===kc||n===Fc||n===Oc||n===Bc||n===zc||n===Hc||n===Vc||n===Gc||n===Wc||n===$c||n===qc||n===Xc)if(o=e.get("WEBGL_compressed_texture_astc"),o!==null){if(n===Ic)return r===Rt?o.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:o.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===Uc)return r===Rt?o.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:o.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===kc)return r===Rt?o.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:o.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===Fc)return r===Rt?o.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:o.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===Oc)return r===Rt?o.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:o.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===Bc)return r===Rt?o.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:o.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===zc)return r===Rt?o.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:o.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===Hc)return r===Rt?o.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:o.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===Vc)return r===Rt?o.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:o.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===Gc)return r===Rt?o.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:o.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===Wc)return r===Rt?o.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:o.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===$c)return r===Rt?o.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:o.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===qc)return r===Rt?o.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:o.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===Xc)return r===Rt?o.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:o.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===wa||n===jc||n===Yc)if(o=e.get("EXT_texture_compression_bptc"),o!==null){if(n===wa)return r===Rt?o.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:o.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===jc)return o.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===Yc)return o.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===fm||n===Kc||n===Zc||n===Jc)if(o=e.get("EXT_texture_compression_rgtc"),o!==null){if(n===wa)return o.COMPRESSED_RED_RGTC1_EXT;if(n===Kc)return o.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===Zc)return o.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===Jc)return o.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===Oo?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:t}}class rD extends Yn{constructor(e=[]){super(),this.isArrayCamera=!0,this.cameras=e}}class yi extends dn{constructor(){super(),this.isGroup=!0,this.type="Group"}}const aD={type:"move"};class Zl{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new yi,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new yi,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new ee,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new ee),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new yi,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new ee,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new ee),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){const t=this._hand;if(t)for(const n of e.hand.values())this._getHandJoint(t,n)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,n){let s=null,o=null,r=null;const a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){r=!0;for(const _ of e.hand.values()){const p=t.getJointPose(_,n),f=this._getHandJoint(c,_);p!==null&&(f.matrix.fromArray(p.transform.matrix),f.matrix.decompose(f.position,f.rotation,f.scale),f.matrixWorldNeedsUpdate=!0,f.jointRadius=p.radius),f.visible=p!==null}const h=c.joints["index-finger-tip"],u=c.joints["thumb-tip"],d=h.position.distanceTo(u.position),m=.02,g=.005;c.inputState.pinching&&d>m+g?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&d<=m-g&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(o=t.getPose(e.gripSpace,n),o!==null&&(l.matrix.fromArray(o.transform.matrix),l.matrix.decompose(l.position,l.rotation,l.scale),l.matrixWorldNeedsUpdate=!0,o.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(o.linearVelocity)):l.hasLinearVelocity=!1,o.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(o.angularVelocity)):l.hasAngularVelocity=!1));a!==null&&(s=t.getPose(e.targetRaySpace,n),s===null&&o!==null&&(s=o),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.rotation,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(aD)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=o!==null),c!==null&&(c.visible=r!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){const n=new yi;n.matrixAutoUpdate=!1,n.visible=!1,e.joints[t.jointName]=n,e.add(n)}return e.joints[t.jointName]}}const lD=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,cD=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`;class hD{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t,n){if(this.texture===null){const s=new En,o=e.properties.get(s);o.__webglTexture=t.texture,(t.depthNear!=n.depthNear||t.depthFar!=n.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=s}}getMesh(e){if(this.texture!==null&&this.mesh===null){const t=e.cameras[0].viewport,n=new ms({vertexShader:lD,fragmentShader:cD,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new un(new Nr(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}}class uD extends Xo{constructor(e,t){super();const n=this;let s=null,o=1,r=null,a="local-floor",l=1,c=null,h=null,u=null,d=null,m=null,g=null;const _=new hD,p=t.getContextAttributes();let f=null,M=null;const S=[],x=[],F=new vt;let P=null;const A=new Yn;A.viewport=new Gt;const I=new Yn;I.viewport=new Gt;const E=[A,I],y=new rD;let R=null,V=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(oe){let ue=S[oe];return ue===void 0&&(ue=new Zl,S[oe]=ue),ue.getTargetRaySpace()},this.getControllerGrip=function(oe){let ue=S[oe];return ue===void 0&&(ue=new Zl,S[oe]=ue),ue.getGripSpace()},this.getHand=function(oe){let ue=S[oe];return ue===void 0&&(ue=new Zl,S[oe]=ue),ue.getHandSpace()};function O(oe){const ue=x.indexOf(oe.inputSource);if(ue===-1)return;const ve=S[ue];ve!==void 0&&(ve.update(oe.inputSource,oe.frame,c||r),ve.dispatchEvent({type:oe.type,data:oe.inputSource}))}function $(){s.removeEventListener("select",O),s.removeEventListener("selectstart",O),s.removeEventListener("selectend",O),s.removeEventListener("squeeze",O),s.removeEventListener("squeezestart",O),s.removeEventListener("squeezeend",O),s.removeEventListener("end",$),s.removeEventListener("inputsourceschange",q);for(let oe=0;oe<S.length;oe++){const ue=x[oe];ue!==null&&(x[oe]=null,S[oe].disconnect(ue))}R=null,V=null,_.reset(),e.setRenderTarget(f),m=null,d=null,u=null,s=null,M=null,ge.stop(),n.isPresenting=!1,e.setPixelRatio(P),e.setSize(F.width,F.height,!1),n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(oe){o=oe,n.isPresenting===!0&&console.warn("THREE.WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(oe){a=oe,n.isPresenting===!0&&console.warn("THREE.WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||r},this.setReferenceSpace=function(oe){c=oe},this.getBaseLayer=function(){return d!==null?d:m},this.getBinding=function(){return u},this.getFrame=function(){return g},this.getSession=function(){return s},this.setSession=async function(oe){if(s=oe,s!==null){if(f=e.getRenderTarget(),s.addEventListener("select",O),s.addEventListener("selectstart",O),s.addEventListener("selectend",O),s.addEventListener("squeeze",O),s.addEventListener("squeezestart",O),s.addEventListener("squeezeend",O),s.addEventListener("end",$),s.addEventListener("inputsourceschange",q),p.xrCompatible!==!0&&await t.makeXRCompatible(),P=e.getPixelRatio(),e.getSize(F),s.renderState.layers===void 0){const ue={antialias:p.antialias,alpha:!0,depth:p.depth,stencil:p.stencil,framebufferScaleFactor:o};m=new XRWebGLLayer(s,t,ue),s.updateRenderState({baseLayer:m}),e.setPixelRatio(1),e.setSize(m.framebufferWidth,m.framebufferHeight,!1),M=new Ws(m.framebufferWidth,m.framebufferHeight,{format:li,type:$i,colorSpace:e.outputColorSpace,stencilBuffer:p.stencil})}else{let ue=null,ve=null,ce=null;p.depth&&(ce=p.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,ue=p.stencil?Bo:Ro,ve=p.stencil?Oo:Gs);const He={colorFormat:t.RGBA8,depthFormat:ce,scaleFactor:o};u=new XRWebGLBinding(s,t),d=u.createProjectionLayer(He),s.updateRenderState({layers:[d]}),e.setPixelRatio(1),e.setSize(d.textureWidth,d.textureHeight,!1),M=new Ws(d.textureWidth,d.textureHeight,{format:li,type:$i,depthTexture:new Rm(d.textureWidth,d.textureHeight,ve,void 0,void 0,void 0,void 0,void 0,void 0,ue),stencilBuffer:p.stencil,colorSpace:e.outputColorSpace,samples:p.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1})}M.isXRRenderTarget=!0,this.setFoveation(l),c=null,r=await s.requestReferenceSpace(a),ge.setContext(s),ge.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return _.getDepthTexture()};function q(oe){for(let ue=0;ue<oe.removed.length;ue++){const ve=oe.removed[ue],ce=x.indexOf(ve);ce>=0&&(x[ce]=null,S[ce].disconnect(ve))}for(let ue=0;ue<oe.added.length;ue++){const ve=oe.added[ue];let ce=x.indexOf(ve);if(ce===-1){for(let Ge=0;Ge<S.length;Ge++)if(Ge>=x.length){x.push(ve),ce=Ge;break}else if(x[Ge]===null){x[Ge]=ve,ce=Ge;break}if(ce===-1)break}const He=S[ce];He&&He.connect(ve)}}const X=new ee,Y=new ee;function te(oe,ue,ve){X.setFromMatrixPosition(ue.matrixWorld),Y.setFromMatrixPosition(ve.matrixWorld);const ce=X.distanceTo(Y),He=ue.projectionMatrix.elements,Ge=ve.projectionMatrix.elements,ke=He[14]/(He[10]-1),ct=He[14]/(He[10]+1),Ze=(He[9]+1)/He[5],ht=(He[9]-1)/He[5],G=(He[8]-1)/He[0],Yt=(Ge[8]+1)/Ge[0],et=ke*G,nt=ke*Yt,We=ce/(-G+Yt),ft=We*-G;if(ue.matrixWorld.decompose(oe.position,oe.quaternion,oe.scale),oe.translateX(ft),oe.translateZ(We),oe.matrixWorld.compose(oe.position,oe.quaternion,oe.scale),oe.matrixWorldInverse.copy(oe.matrixWorld).invert(),He[10]===-1)oe.projectionMatrix.copy(ue.projectionMatrix),oe.projectionMatrixInverse.copy(ue.projectionMatrixInverse);else{const Ne=ke+We,L=ct+We,w=et-ft,Q=nt+(ce-ft),ne=Ze*ct/L*Ne,j=ht*ct/L*Ne;oe.projectionMatrix.makePerspective(w,Q,ne,j,Ne,L),oe.projectionMatrixInverse.copy(oe.projectionMatrix).invert()}}function le(oe,ue){ue===null?oe.matrixWorld.copy(oe.matrix):oe.matrixWorld.multiplyMatrices(ue.matrixWorld,oe.matrix),oe.matrixWorldInverse.copy(oe.matrixWorld).invert()}this.updateCamera=function(oe){if(s===null)return;let ue=oe.near,ve=oe.far;_.texture!==null&&(_.depthNear>0&&(ue=_.depthNear),_.depthFar>0&&(ve=_.depthFar)),y.near=I.near=A.near=ue,y.far=I.far=A.far=ve,(R!==y.near||V!==y.far)&&(s.updateRenderState({depthNear:y.near,depthFar:y.far}),R=y.near,V=y.far),A.layers.mask=oe.layers.mask|2,I.layers.mask=oe.layers.mask|4,y.layers.mask=A.layers.mask|I.layers.mask;const ce=oe.parent,He=y.cameras;le(y,ce);for(let Ge=0;Ge<He.length;Ge++)le(He[Ge],ce);He.length===2?te(y,A,I):y.projectionMatrix.copy(A.projectionMatrix),he(oe,y,ce)};function he(oe,ue,ve){ve===null?oe.matrix.copy(ue.matrixWorld):(oe.matrix.copy(ve.matrixWorld),oe.matrix.invert(),oe.matrix.multiply(ue.matrixWorld)),oe.matrix.decompose(oe.position,oe.quaternion,oe.scale),oe.updateMatrixWorld(!0),oe.projectionMatrix.copy(ue.projectionMatrix),oe.projectionMatrixInverse.copy(ue.projectionMatrixInverse),oe.isPerspectiveCamera&&(oe.fov=Qc*2*Math.atan(1/oe.projectionMatrix.elements[5]),oe.zoom=1)}this.getCamera=function(){return y},this.getFoveation=function(){if(!(d===null&&m===null))return l},this.setFoveation=function(oe){l=oe,d!==null&&(d.fixedFoveation=oe),m!==null&&m.fixedFoveation!==void 0&&(m.fixedFoveation=oe)},this.hasDepthSensing=function(){return _.texture!==null},this.getDepthSensingMesh=function(){return _.getMesh(y)};let _e=null;function Me(oe,ue){if(h=ue.getViewerPose(c||r),g=ue,h!==null){const ve=h.views;m!==null&&(e.setRenderTargetFramebuffer(M,m.framebuffer),e.setRenderTarget(M));let ce=!1;ve.length!==y.cameras.length&&(y.cameras.length=0,ce=!0);for(let Ge=0;Ge<ve.length;Ge++){const ke=ve[Ge];let ct=null;if(m!==null)ct=m.getViewport(ke);else{const ht=u.getViewSubImage(d,ke);ct=ht.viewport,Ge===0&&(e.setRenderTargetTextures(M,ht.colorTexture,d.ignoreDepthValues?void 0:ht.depthStencilTexture),e.setRenderTarget(M))}let Ze=E[Ge];Ze===void 0&&(Ze=new Yn,Ze.layers.enable(Ge),Ze.viewport=new Gt,E[Ge]=Ze),Ze.matrix.fromArray(ke.transform.matrix),Ze.matrix.decompose(Ze.position,Ze.quaternion,Ze.scale),Ze.projectionMatrix.fromArray(ke.projectionMatrix),Ze.projectionMatrixInverse.copy(Ze.projectionMatrix).invert(),Ze.viewport.set(ct.x,ct.y,ct.width,ct.height),Ge===0&&(y.matrix.copy(Ze.matrix),y.matrix.decompose(y.position,y.quaternion,y.scale)),ce===!0&&y.cameras.push(Ze)}const He=s.enabledFeatures;if(He&&He.includes("depth-sensing")){const Ge=u.getDepthInformation(ve[0]);Ge&&Ge.isValid&&Ge.texture&&_.init(e,Ge,s.renderState)}}for(let ve=0;ve<S.length;ve++){const ce=x[ve],He=S[ve];ce!==null&&He!==void 0&&He.update(ce,ue,c||r)}_e&&_e(oe,ue),ue.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:ue}),g=null}const ge=new Tm;ge.setAnimationLoop(Me),this.setAnimationLoop=function(oe){_e=oe},this.dispose=function(){}}}const Rs=new Ei,dD=new zt;function fD(i,e){function t(p,f){p.matrixAutoUpdate===!0&&p.updateMatrix(),f.value.copy(p.matrix)}function n(p,f){f.color.getRGB(p.fogColor.value,Sm(i)),f.isFog?(p.fogNear.value=f.near,p.fogFar.value=f.far):f.isFogExp2&&(p.fogDensity.value=f.density)}function s(p,f,M,S,x){f.isMeshBasicMaterial||f.isMeshLambertMaterial?o(p,f):f.isMeshToonMaterial?(o(p,f),u(p,f)):f.isMeshPhongMaterial?(o(p,f),h(p,f)):f.isMeshStandardMaterial?(o(p,f),d(p,f),f.isMeshPhysicalMaterial&&m(p,f,x)):f.isMeshMatcapMaterial?(o(p,f),g(p,f)):f.isMeshDepthMaterial?o(p,f):f.isMeshDistanceMaterial?(o(p,f),_(p,f)):f.isMeshNormalMaterial?o(p,f):f.isLineBasicMaterial?(r(p,f),f.isLineDashedMaterial&&a(p,f)):f.isPointsMaterial?l(p,f,M,S):f.isSpriteMaterial?c(p,f):f.isShadowMaterial?(p.color.value.copy(f.color),p.opacity.value=f.opacity):f.isShaderMaterial&&(f.uniformsNeedUpdate=!1)}function o(p,f){p.opacity.value=f.opacity,f.color&&p.diffuse.value.copy(f.color),f.emissive&&p.emissive.value.copy(f.emissive).multiplyScalar(f.emissiveIntensity),f.map&&(p.map.value=f.map,t(f.map,p.mapTransform)),f.alphaMap&&(p.alphaMap.value=f.alphaMap,t(f.alphaMap,p.alphaMapTransform)),f.bumpMap&&(p.bumpMap.value=f.bumpMap,t(f.bumpMap,p.bumpMapTransform),p.bumpScale.value=f.bumpScale,f.side===Pn&&(p.bumpScale.value*=-1)),f.normalMap&&(p.normalMap.value=f.normalMap,t(f.normalMap,p.normalMapTransform),p.normalScale.value.copy(f.normalScale),f.side===Pn&&p.normalScale.value.negate()),f.displacementMap&&(p.displacementMap.value=f.displacementMap,t(f.displacementMap,p.displacementMapTransform),p.displacementScale.value=f.displacementScale,p.displacementBias.value=f.displacementBias),f.emissiveMap&&(p.emissiveMap.value=f.emissiveMap,t(f.emissiveMap,p.emissiveMapTransform)),f.specularMap&&(p.specularMap.value=f.specularMap,t(f.specularMap,p.specularMapTransform)),f.alphaTest>0&&(p.alphaTest.value=f.alphaTest);const M=e.get(f),S=M.envMap,x=M.envMapRotation;S&&(p.envMap.value=S,Rs.copy(x),Rs.x*=-1,Rs.y*=-1,Rs.z*=-1,S.isCubeTexture&&S.isRenderTargetTexture===!1&&(Rs.y*=-1,Rs.z*=-1),p.envMapRotation.value.setFromMatrix4(dD.makeRotationFromEuler(Rs)),p.flipEnvMap.value=S.isCubeTexture&&S.isRenderTargetTexture===!1?-1:1,p.reflectivity.value=f.reflectivity,p.ior.value=f.ior,p.refractionRatio.value=f.refractionRatio),f.lightMap&&(p.lightMap.value=f.lightMap,p.lightMapIntensity.value=f.lightMapIntensity,t(f.lightMap,p.lightMapTransform)),f.aoMap&&(p.aoMap.value=f.aoMap,p.aoMapIntensity.value=f.aoMapIntensity,t(f.aoMap,p.aoMapTransform))}function r(p,f){p.diffuse.value.copy(f.color),p.opacity.value=f.opacity,f.map&&(p.map.value=f.map,t(f.map,p.mapTransform))}function a(p,f){p.dashSize.value=f.dashSize,p.totalSize.value=f.dashSize+f.gapSize,p.scale.value=f.scale}function l(p,f,M,S){p.diffuse.value.copy(f.color),p.opacity.value=f.opacity,p.size.value=f.size*M,p.scale.value=S*.5,f.map&&(p.map.value=f.map,t(f.map,p.uvTransform)),f.alphaMap&&(p.alphaMap.value=f.alphaMap,t(f.alphaMap,p.alphaMapTransform)),f.alphaTest>0&&(p.alphaTest.value=f.alphaTest)}function c(p,f){p.diffuse.value.copy(f.color),p.opacity.value=f.opacity,p.rotation.value=f.rotation,f.map&&(p.map.value=f.map,t(f.map,p.mapTransform)),f.alphaMap&&(p.alphaMap.value=f.alphaMap,t(f.alphaMap,p.alphaMapTransform)),f.alphaTest>0&&(p.alphaTest.value=f.alphaTest)}function h(p,f){p.specular.value.copy(f.specular),p.shininess.value=Math.max(f.shininess,1e-4)}function u(p,f){f.gradientMap&&(p.gradientMap.value=f.gradientMap)}function d(p,f){p.metalness.value=f.metalness,f.metalnessMap&&(p.metalnessMap.value=f.metalnessMap,t(f.metalnessMap,p.metalnessMapTransform)),p.roughness.value=f.roughness,f.roughnessMap&&(p.roughnessMap.value=f.roughnessMap,t(f.roughnessMap,p.roughnessMapTransform)),f.envMap&&(p.envMapIntensity.value=f.envMapIntensity)}function m(p,f,M){p.ior.value=f.ior,f.sheen>0&&(p.sheenColor.value.copy(f.sheenColor).multiplyScalar(f.sheen),p.sheenRoughness.value=f.sheenRoughness,f.sheenColorMap&&(p.sheenColorMap.value=f.sheenColorMap,t(f.sheenColorMap,p.sheenColorMapTransform)),f.sheenRoughnessMap&&(p.sheenRoughnessMap.value=f.sheenRoughnessMap,t(f.sheenRoughnessMap,p.sheenRoughnessMapTransform))),f.clearcoat>0&&(p.clearcoat.value=f.clearcoat,p.clearcoatRoughness.value=f.clearcoatRoughness,f.clearcoatMap&&(p.clearcoatMap.value=f.clearcoatMap,t(f.clearcoatMap,p.clearcoatMapTransform)),f.clearcoatRoughnessMap&&(p.clearcoatRoughnessMap.value=f.clearcoatRoughnessMap,t(f.clearcoatRoughnessMap,p.clearcoatRoughnessMapTransform)),f.clearcoatNormalMap&&(p.clearcoatNormalMap.value=f.clearcoatNormalMap,t(f.clearcoatNormalMap,p.clearcoatNormalMapTransform),p.clearcoatNormalScale.value.copy(f.clearcoatNormalScale),f.side===Pn&&p.clearcoatNormalScale.value.negate())),f.dispersion>0&&(p.dispersion.value=f.dispersion),f.iridescence>0&&(p.iridescence.value=f.iridescence,p.iridescenceIOR.value=f.iridescenceIOR,p.iridescenceThicknessMinimum.value=f.iridescenceThicknessRange[0],p.iridescenceThicknessMaximum.value=f.iridescenceThicknessRange[1],f.iridescenceMap&&(p.iridescenceMap.value=f.iridescenceMap,t(f.iridescenceMap,p.iridescenceMapTransform)),f.iridescenceThicknessMap&&(p.iridescenceThicknessMap.value=f.iridescenceThicknessMap,t(f.iridescenceThicknessMap,p.iridescenceThicknessMapTransform))),f.transmission>0&&(p.transmission.value=f.transmission,p.transmissionSamplerMap.value=M.texture,p.transmissionSamplerSize.value.set(M.width,M.height),f.transmissionMap&&(p.transmissionMap.value=f.transmissionMap,t(f.transmissionMap,p.transmissionMapTransform)),p.thickness.value=f.thickness,f.thicknessMap&&(p.thicknessMap.value=f.thicknessMap,t(f.thicknessMap,p.thicknessMapTransform)),p.attenuationDistance.value=f.attenuationDistance,p.attenuationColor.value.copy(f.attenuationColor)),f.anisotropy>0&&(p.anisotropyVector.value.set(f.anisotropy*Math.cos(f.anisotropyRotation),f.anisotropy*Math.sin(f.anisotropyRotation)),f.anisotropyMap&&(p.anisotropyMap.value=f.anisotropyMap,t(f.anisotropyMap,p.anisotropyMapTransform))),p.specularIntensity.value=f.specularIntensity,p.specularColor.value.copy(f.specularColor),f.specularColorMap&&(p.specularColorMap.value=f.specularColorMap,t(f.specularColorMap,p.specularColorMapTransform)),f.specularIntensityMap&&(p.specularIntensityMap.value=f.specularIntensityMap,t(f.specularIntensityMap,p.specularIntensityMapTransform))}function g(p,f){f.matcap&&(p.matcap.value=f.matcap)}function _(p,f){const M=e.get(f).light;p.referencePosition.value.setFromMatrixPosition(M.matrixWorld),p.nearDistance.value=M.shadow.camera.near,p.farDistance.value=M.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function pD(i,e,t,n){let s={},o={},r=[];const a=i.getParameter(i.MAX_UNIFORM_BUFFER_BINDINGS);function l(M,S){const x=S.program;n.uniformBlockBinding(M,x)}function c(M,S){let x=s[M.id];x===void 0&&(g(M),x=h(M),s[M.id]=x,M.addEventListener("dispose",p));const F=S.program;n.updateUBOMapping(M,F);const P=e.render.frame;o[M.id]!==P&&(d(M),o[M.id]=P)}function h(M){const S=u();M.__bindingPointIndex=S;const x=i.createBuffer(),F=M.__size,P=M.usage;return i.bindBuffer(i.UNIFORM_BUFFER,x),i.bufferData(i.UNIFORM_BUFFER,F,P),i.bindBuffer(i.UNIFORM_BUFFER,null),i.bindBufferBase(i.UNIFORM_BUFFER,S,x),x}function u(){for(let M=0;M<a;M++)if(r.indexOf(M)===-1)return r.push(M),M;return console.error("THREE.WebGLRenderer: Maximum number of simultaneously usable uniforms groups reached."),0}function d(M){const S=s[M.id],x=M.uniforms,F=M.__cache;i.bindBuffer(i.UNIFORM_BUFFER,S);for(let P=0,A=x.length;P<A;P++){const I=Array.isArray(x[P])?x[P]:[x[P]];for(let E=0,y=I.length;E<y;E++){const R=I[E];if(m(R,P,E,F)===!0){const V=R.__offset,O=Array.isArray(R.value)?R.value:[R.value];let $=0;for(let q=0;q<O.length;q++){const X=O[q],Y=_(X);typeof X=="number"||typeof X=="boolean"?(R.__data[0]=X,i.bufferSubData(i.UNIFORM_BUFFER,V+$,R.__data)):X.isMatrix3?(R.__data[0]=X.elements[0],R.__data[1]=X.elements[1],R.__data[2]=X.elements[2],R.__data[3]=0,R.__data[4]=X.elements[3],R.__data[5]=X.elements[4],R.__data[6]=X.elements[5],R.__data[7]=0,R.__data[8]=X.elements[6],R.__data[9]=X.elements[7],R.__data[10]=X.elements[8],R.__data[11]=0):(X.toArray(R.__data,$),$+=Y.storage/Float32Array.BYTES_PER_ELEMENT)}i.bufferSubData(i.UNIFORM_BUFFER,V,R.__data)}}}i.bindBuffer(i.UNIFORM_BUFFER,null)}function m(M,S,x,F){const P=M.value,A=S+"_"+x;if(F[A]===void 0)return typeof P=="number"||typeof P=="boolean"?F[A]=P:F[A]=P.clone(),!0;{const I=F[A];if(typeof P=="number"||typeof P=="boolean"){if(I!==P)return F[A]=P,!0}else if(I.equals(P)===!1)return I.copy(P),!0}return!1}function g(M){const S=M.uniforms;let x=0;const F=16;for(let A=0,I=S.length;A<I;A++){const E=Array.isArray(S[A])?S[A]:[S[A]];for(let y=0,R=E.length;y<R;y++){const V=E[y],O=Array.isArray(V.value)?V.value:[V.value];for(let $=0,q=O.length;$<q;$++){const X=O[$],Y=_(X),te=x%F,le=te%Y.boundary,he=te+le;x+=le,he!==0&&F-he<Y.storage&&(x+=F-he),V.__data=new Float32Array(Y.storage/Float32Array.BYTES_PER_ELEMENT),V.__offset=x,x+=Y.storage}}}const P=x%F;return P>0&&(x+=F-P),M.__size=x,M.__cache={},this}function _(M){const S={boundary:0,storage:0};return typeof M=="number"||typeof M=="boolean"?(S.boundary=4,S.storage=4):M.isVector2?(S.boundary=8,S.storage=8):M.isVector3||M.isColor?(S.boundary=16,S.storage=12):M.isVector4?(S.boundary=16,S.storage=16):M.isMatrix3?(S.boundary=48,S.storage=48):M.isMatrix4?(S.boundary=64,S.storage=64):M.isTexture?console.warn("THREE.WebGLRenderer: Texture samplers can not be part of an uniforms group."):console.warn("THREE.WebGLRenderer: Unsupported uniform value type.",M),S}function p(M){const S=M.target;S.removeEventListener("dispose",p);const x=r.indexOf(S.__bindingPointIndex);r.splice(x,1),i.deleteBuffer(s[S.id]),delete s[S.id],delete o[S.id]}function f(){for(const M in s)i.deleteBuffer(s[M]);r=[],s={},o={}}return{bind:l,update:c,dispose:f}}class mD{constructor(e={}){const{canvas:t=iC(),context:n=null,depth:s=!0,stencil:o=!1,alpha:r=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:u=!1,reverseDepthBuffer:d=!1}=e;this.isWebGLRenderer=!0;let m;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");m=n.getContextAttributes().alpha}else m=r;const g=new Uint32Array(4),_=new Int32Array(4);let p=null,f=null;const M=[],S=[];this.domElement=t,this.debug={checkShaderErrors:!0,onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this._outputColorSpace=On,this.toneMapping=hs,this.toneMappingExposure=1;const x=this;let F=!1,P=0,A=0,I=null,E=-1,y=null;const R=new Gt,V=new Gt;let O=null;const $=new dt(0);let q=0,X=t.width,Y=t.height,te=1,le=null,he=null;const _e=new Gt(0,0,X,Y),Me=new Gt(0,0,X,Y);let ge=!1;const oe=new zh;let ue=!1,ve=!1;const ce=new zt,He=new zt,Ge=new ee,ke=new Gt,ct={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0};let Ze=!1;function ht(){return I===null?te:1}let G=n;function Yt(T,z){return t.getContext(T,z)}try{const T={alpha:!0,depth:s,stencil:o,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:u};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${Ph}`),t.addEventListener("webglcontextlost",ae,!1),t.addEventListener("webglcontextrestored",Re,!1),t.addEventListener("webglcontextcreationerror",Ce,!1),G===null){const z="webgl2";if(G=Yt(z,T),G===null)throw Yt(z)?new Error("Error creating WebGL context with your selected attributes."):new Error("Error creating WebGL context.")}}catch(T){throw console.error("THREE.WebGLRenderer: "+T.message),T}let et,nt,We,ft,Ne,L,w,Q,ne,j,ie,Se,xe,Ae,Ke,pe,be,Fe,Be,Ee,st,je,pt,H;function ye(){et=new bL(G),et.init(),je=new oD(G,et),nt=new pL(G,et,e,je),We=new nD(G,et),nt.reverseDepthBuffer&&d&&We.buffers.depth.setReversed(!0),ft=new SL(G),Ne=new HN,L=new sD(G,et,We,Ne,nt,je,ft),w=new gL(x),Q=new xL(x),ne=new PC(G),pt=new dL(G,ne),j=new yL(G,ne,ft,pt),ie=new EL(G,j,ne,ft),Be=new wL(G,nt,L),pe=new mL(Ne),Se=new zN(x,w,Q,et,nt,pt,pe),xe=new fD(x,Ne),Ae=new GN,Ke=new YN(et),Fe=new uL(x,w,Q,We,ie,m,l),be=new eD(x,ie,nt),H=new pD(G,ft,nt,We),Ee=new fL(G,et,ft),st=new ML(G,et,ft),ft.programs=Se.programs,x.capabilities=nt,x.extensions=et,x.properties=Ne,x.renderLists=Ae,x.shadowMap=be,x.state=We,x.info=ft}ye();const se=new uD(x,G);this.xr=se,this.getContext=function(){return G},this.getContextAttributes=function(){return G.getContextAttributes()},this.forceContextLoss=function(){const T=et.get("WEBGL_lose_context");T&&T.loseContext()},this.forceContextRestore=function(){const T=et.get("WEBGL_lose_context");T&&T.restoreContext()},this.getPixelRatio=function(){return te},this.setPixelRatio=function(T){T!==void 0&&(te=T,this.setSize(X,Y,!1))},this.getSize=function(T){return T.set(X,Y)},this.setSize=function(T,z,K=!0){if(se.isPresenting){console.warn("THREE.WebGLRenderer: Can't change size while VR device is presenting.");return}X=T,Y=z,t.width=Math.floor(T*te),t.height=Math.floor(z*te),K===!0&&(t.style.width=T+"px",t.style.height=z+"px"),this.setViewport(0,0,T,z)},this.getDrawingBufferSize=function(T){return T.set(X*te,Y*te).floor()},this.setDrawingBufferSize=function(T,z,K){X=T,Y=z,te=K,t.width=Math.floor(T*K),t.height=Math.floor(z*K),this.setViewport(0,0,T,z)},this.getCurrentViewport=function(T){return T.copy(R)},this.getViewport=function(T){return T.copy(_e)},this.setViewport=function(T,z,K,Z){T.isVector4?_e.set(T.x,T.y,T.z,T.w):_e.set(T,z,K,Z),We.viewport(R.copy(_e).multiplyScalar(te).round())},this.getScissor=function(T){return T.copy(Me)},this.setScissor=function(T,z,K,Z){T.isVector4?Me.set(T.x,T.y,T.z,T.w):Me.set(T,z,K,Z),We.scissor(V.copy(Me).multiplyScalar(te).round())},this.getScissorTest=function(){return ge},this.setScissorTest=function(T){We.setScissorTest(ge=T)},this.setOpaqueSort=function(T){le=T},this.setTransparentSort=function(T){he=T},this.getClearColor=function(T){return T.copy(Fe.getClearColor())},this.setClearColor=function(){Fe.setClearColor.apply(Fe,arguments)},this.getClearAlpha=function(){return Fe.getClearAlpha()},this.setClearAlpha=function(){Fe.setClearAlpha.apply(Fe,arguments)},this.clear=function(T=!0,z=!0,K=!0){let Z=0;if(T){let W=!1;if(I!==null){const fe=I.texture.format;W=fe===kh||fe===Uh||fe===Ih}if(W){const fe=I.texture.type,we=fe===$i||fe===Gs||fe===wr||fe===Oo||fe===Nh||fe===Dh,Oe=Fe.getClearColor(),Ie=Fe.getClearAlpha(),$e=Oe.r,Xe=Oe.g,Ue=Oe.b;we?(g[0]=$e,g[1]=Xe,g[2]=Ue,g[3]=Ie,G.clearBufferuiv(G.COLOR,0,g)):(_[0]=$e,_[1]=Xe,_[2]=Ue,_[3]=Ie,G.clearBufferiv(G.COLOR,0,_))}else Z|=G.COLOR_BUFFER_BIT}z&&(Z|=G.DEPTH_BUFFER_BIT),K&&(Z|=G.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),G.clear(Z)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.dispose=function(){t.removeEventListener("webglcontextlost",ae,!1),t.removeEventListener("webglcontextrestored",Re,!1),t.removeEventListener("webglcontextcreationerror",Ce,!1),Ae.dispose(),Ke.dispose(),Ne.dispose(),w.dispose(),Q.dispose(),ie.dispose(),pt.dispose(),H.dispose(),Se.dispose(),se.dispose(),se.removeEventListener("sessionstart",Ln),se.removeEventListener("sessionend",Ti),Tn.stop()};function ae(T){T.preventDefault(),console.log("THREE.WebGLRenderer: Context Lost."),F=!0}function Re(){console.log("THREE.WebGLRenderer: Context Restored."),F=!1;const T=ft.autoReset,z=be.enabled,K=be.autoUpdate,Z=be.needsUpdate,W=be.type;ye(),ft.autoReset=T,be.enabled=z,be.autoUpdate=K,be.needsUpdate=Z,be.type=W}function Ce(T){console.error("THREE.WebGLRenderer: A WebGL context could not be created. Reason: ",T.statusMessage)}function Je(T){const z=T.target;z.removeEventListener("dispose",Je),Ft(z)}function Ft(T){nn(T),Ne.remove(T)}function nn(T){const z=Ne.get(T).programs;z!==void 0&&(z.forEach(function(K){Se.releaseProgram(K)}),T.isShaderMaterial&&Se.releaseShaderCache(T))}this.renderBufferDirect=function(T,z,K,Z,W,fe){z===null&&(z=ct);const we=W.isMesh&&W.matrixWorld.determinant()<0,Oe=Ja(T,z,K,Z,W);We.setMaterial(Z,we);let Ie=K.index,$e=1;if(Z.wireframe===!0){if(Ie=j.getWireframeAttribute(K),Ie===void 0)return;$e=2}const Xe=K.drawRange,Ue=K.attributes.position;let rt=Xe.start*$e,wt=(Xe.start+Xe.count)*$e;fe!==null&&(rt=Math.max(rt,fe.start*$e),wt=Math.min(wt,(fe.start+fe.count)*$e)),Ie!==null?(rt=Math.max(rt,0),wt=Math.min(wt,Ie.count)):Ue!=null&&(rt=Math.max(rt,0),wt=Math.min(wt,Ue.count));const Tt=wt-rt;if(Tt<0||Tt===1/0)return;pt.setup(W,Z,Oe,K,Ie);let sn,ut=Ee;if(Ie!==null&&(sn=ne.get(Ie),ut=st,ut.setIndex(sn)),W.isMesh)Z.wireframe===!0?(We.setLineWidth(Z.wireframeLinewidth*ht()),ut.setMode(G.LINES)):ut.setMode(G.TRIANGLES);else if(W.isLine){let ze=Z.linewidth;ze===void 0&&(ze=1),We.setLineWidth(ze*ht()),W.isLineSegments?ut.setMode(G.LINES):W.isLineLoop?ut.setMode(G.LINE_LOOP):ut.setMode(G.LINE_STRIP)}else W.isPoints?ut.setMode(G.POINTS):W.isSprite&&ut.setMode(G.TRIANGLES);if(W.isBatchedMesh)if(W._multiDrawInstances!==null)ut.renderMultiDrawInstances(W._multiDrawStarts,W._multiDrawCounts,W._multiDrawCount,W._multiDrawInstances);else if(et.get("WEBGL_multi_draw"))ut.renderMultiDraw(W._multiDrawStarts,W._multiDrawCounts,W._multiDrawCount);else{const ze=W._multiDrawStarts,Ot=W._multiDrawCounts,mt=W._multiDrawCount,An=Ie?ne.get(Ie).bytesPerElement:1,ui=Ne.get(Z).currentProgram.getUniforms();for(let pn=0;pn<mt;pn++)ui.setValue(G,"_gl_DrawID",pn),ut.render(ze[pn]/An,Ot[pn])}else if(W.isInstancedMesh)ut.renderInstances(rt,Tt,W.count);else if(K.isInstancedBufferGeometry){const ze=K._maxInstanceCount!==void 0?K._maxInstanceCount:1/0,Ot=Math.min(K.instanceCount,ze);ut.renderInstances(rt,Tt,Ot)}else ut.render(rt,Tt)};function yt(T,z,K){T.transparent===!0&&T.side===Fi&&T.forceSinglePass===!1?(T.side=Pn,T.needsUpdate=!0,js(T,z,K),T.side=ps,T.needsUpdate=!0,js(T,z,K),T.side=Fi):js(T,z,K)}this.compile=function(T,z,K=null){K===null&&(K=T),f=Ke.get(K),f.init(z),S.push(f),K.traverseVisible(function(W){W.isLight&&W.layers.test(z.layers)&&(f.pushLight(W),W.castShadow&&f.pushShadow(W))}),T!==K&&T.traverseVisible(function(W){W.isLight&&W.layers.test(z.layers)&&(f.pushLight(W),W.castShadow&&f.pushShadow(W))}),f.setupLights();const Z=new Set;return T.traverse(function(W){if(!(W.isMesh||W.isPoints||W.isLine||W.isSprite))return;const fe=W.material;if(fe)if(Array.isArray(fe))for(let we=0;we<fe.length;we++){const Oe=fe[we];yt(Oe,K,W),Z.add(Oe)}else yt(fe,K,W),Z.add(fe)}),S.pop(),f=null,Z},this.compileAsync=function(T,z,K=null){const Z=this.compile(T,z,K);return new Promise(W=>{function fe(){if(Z.forEach(function(we){Ne.get(we).currentProgram.isReady()&&Z.delete(we)}),Z.size===0){W(T);return}setTimeout(fe,10)}et.get("KHR_parallel_shader_compile")!==null?fe():setTimeout(fe,10)})};let Kt=null;function Nt(T){Kt&&Kt(T)}function Ln(){Tn.stop()}function Ti(){Tn.start()}const Tn=new Tm;Tn.setAnimationLoop(Nt),typeof self<"u"&&Tn.setContext(self),this.setAnimationLoop=function(T){Kt=T,se.setAnimationLoop(T),T===null?Tn.stop():Tn.start()},se.addEventListener("sessionstart",Ln),se.addEventListener("sessionend",Ti),this.render=function(T,z){if(z!==void 0&&z.isCamera!==!0){console.error("THREE.WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(F===!0)return;if(T.matrixWorldAutoUpdate===!0&&T.updateMatrixWorld(),z.parent===null&&z.matrixWorldAutoUpdate===!0&&z.updateMatrixWorld(),se.enabled===!0&&se.isPresenting===!0&&(se.cameraAutoUpdate===!0&&se.updateCamera(z),z=se.getCamera()),T.isScene===!0&&T.onBeforeRender(x,T,z,I),f=Ke.get(T,S.length),f.init(z),S.push(f),He.multiplyMatrices(z.projectionMatrix,z.matrixWorldInverse),oe.setFromProjectionMatrix(He),ve=this.localClippingEnabled,ue=pe.init(this.clippingPlanes,ve),p=Ae.get(T,M.length),p.init(),M.push(p),se.enabled===!0&&se.isPresenting===!0){const fe=x.xr.getDepthSensingMesh();fe!==null&&fn(fe,z,-1/0,x.sortObjects)}fn(T,z,0,x.sortObjects),p.finish(),x.sortObjects===!0&&p.sort(le,he),Ze=se.enabled===!1||se.isPresenting===!1||se.hasDepthSensing()===!1,Ze&&Fe.addToRenderList(p,T),this.info.render.frame++,ue===!0&&pe.beginShadows();const K=f.state.shadowsArray;be.render(K,T,z),ue===!0&&pe.endShadows(),this.info.autoReset===!0&&this.info.reset();const Z=p.opaque,W=p.transmissive;if(f.setupLights(),z.isArrayCamera){const fe=z.cameras;if(W.length>0)for(let we=0,Oe=fe.length;we<Oe;we++){const Ie=fe[we];Ri(Z,W,T,Ie)}Ze&&Fe.render(T);for(let we=0,Oe=fe.length;we<Oe;we++){const Ie=fe[we];Ai(p,T,Ie,Ie.viewport)}}else W.length>0&&Ri(Z,W,T,z),Ze&&Fe.render(T),Ai(p,T,z);I!==null&&(L.updateMultisampleRenderTarget(I),L.updateRenderTargetMipmap(I)),T.isScene===!0&&T.onAfterRender(x,T,z),pt.resetDefaultState(),E=-1,y=null,S.pop(),S.length>0?(f=S[S.length-1],ue===!0&&pe.setGlobalState(x.clippingPlanes,f.state.camera)):f=null,M.pop(),M.length>0?p=M[M.length-1]:p=null};function fn(T,z,K,Z){if(T.visible===!1)return;if(T.layers.test(z.layers)){if(T.isGroup)K=T.renderOrder;else if(T.isLOD)T.autoUpdate===!0&&T.update(z);else if(T.isLight)f.pushLight(T),T.castShadow&&f.pushShadow(T);else if(T.isSprite){if(!T.frustumCulled||oe.intersectsSprite(T)){Z&&ke.setFromMatrixPosition(T.matrixWorld).applyMatrix4(He);const we=ie.update(T),Oe=T.material;Oe.visible&&p.push(T,we,Oe,K,ke.z,null)}}else if((T.isMesh||T.isLine||T.isPoints)&&(!T.frustumCulled||oe.intersectsObject(T))){const we=ie.update(T),Oe=T.material;if(Z&&(T.boundingSphere!==void 0?(T.boundingSphere===null&&T.computeBoundingSphere(),ke.copy(T.boundingSphere.center)):(we.boundingSphere===null&&we.computeBoundingSphere(),ke.copy(we.boundingSphere.center)),ke.applyMatrix4(T.matrixWorld).applyMatrix4(He)),Array.isArray(Oe)){const Ie=we.groups;for(let $e=0,Xe=Ie.length;$e<Xe;$e++){const Ue=Ie[$e],rt=Oe[Ue.materialIndex];rt&&rt.visible&&p.push(T,we,rt,K,ke.z,Ue)}}else Oe.visible&&p.push(T,we,Oe,K,ke.z,null)}}const fe=T.children;for(let we=0,Oe=fe.length;we<Oe;we++)fn(fe[we],z,K,Z)}function Ai(T,z,K,Z){const W=T.opaque,fe=T.transmissive,we=T.transparent;f.setupLightsView(K),ue===!0&&pe.setGlobalState(x.clippingPlanes,K),Z&&We.viewport(R.copy(Z)),W.length>0&&_s(W,z,K),fe.length>0&&_s(fe,z,K),we.length>0&&_s(we,z,K),We.buffers.depth.setTest(!0),We.buffers.depth.setMask(!0),We.buffers.color.setMask(!0),We.setPolygonOffset(!1)}function Ri(T,z,K,Z){if((K.isScene===!0?K.overrideMaterial:null)!==null)return;f.state.transmissionRenderTarget[Z.id]===void 0&&(f.state.transmissionRenderTarget[Z.id]=new Ws(1,1,{generateMipmaps:!0,type:et.has("EXT_color_buffer_half_float")||et.has("EXT_color_buffer_float")?Ar:$i,minFilter:Os,samples:4,stencilBuffer:o,resolveDepthBuffer:!1,resolveStencilBuffer:!1,colorSpace:gt.workingColorSpace}));const fe=f.state.transmissionRenderTarget[Z.id],we=Z.viewport||R;fe.setSize(we.z,we.w);const Oe=x.getRenderTarget();x.setRenderTarget(fe),x.getClearColor($),q=x.getClearAlpha(),q<1&&x.setClearColor(16777215,.5),x.clear(),Ze&&Fe.render(K);const Ie=x.toneMapping;x.toneMapping=hs;const $e=Z.viewport;if(Z.viewport!==void 0&&(Z.viewport=void 0),f.setupLightsView(Z),ue===!0&&pe.setGlobalState(x.clippingPlanes,Z),_s(T,K,Z),L.updateMultisampleRenderTarget(fe),L.updateRenderTargetMipmap(fe),et.has("WEBGL_multisampled_render_to_texture")===!1){let Xe=!1;for(let Ue=0,rt=z.length;Ue<rt;Ue++){const wt=z[Ue],Tt=wt.object,sn=wt.geometry,ut=wt.material,ze=wt.group;if(ut.side===Fi&&Tt.layers.test(Z.layers)){const Ot=ut.side;ut.side=Pn,ut.needsUpdate=!0,Ko(Tt,K,Z,sn,ut,ze),ut.side=Ot,ut.needsUpdate=!0,Xe=!0}}Xe===!0&&(L.updateMultisampleRenderTarget(fe),L.updateRenderTargetMipmap(fe))}x.setRenderTarget(Oe),x.setClearColor($,q),$e!==void 0&&(Z.viewport=$e),x.toneMapping=Ie}function _s(T,z,K){const Z=z.isScene===!0?z.overrideMaterial:null;for(let W=0,fe=T.length;W<fe;W++){const we=T[W],Oe=we.object,Ie=we.geometry,$e=Z===null?we.material:Z,Xe=we.group;Oe.layers.test(K.layers)&&Ko(Oe,z,K,Ie,$e,Xe)}}function Ko(T,z,K,Z,W,fe){T.onBeforeRender(x,z,K,Z,W,fe),T.modelViewMatrix.multiplyMatrices(K.matrixWorldInverse,T.matrixWorld),T.normalMatrix.getNormalMatrix(T.modelViewMatrix),W.onBeforeRender(x,z,K,Z,T,fe),W.transparent===!0&&W.side===Fi&&W.forceSinglePass===!1?(W.side=Pn,W.needsUpdate=!0,x.renderBufferDirect(K,z,Z,W,T,fe),W.side=ps,W.needsUpdate=!0,x.renderBufferDirect(K,z,Z,W,T,fe),W.side=Fi):x.renderBufferDirect(K,z,Z,W,T,fe),T.onAfterRender(x,z,K,Z,W,fe)}function js(T,z,K){z.isScene!==!0&&(z=ct);const Z=Ne.get(T),W=f.state.lights,fe=f.state.shadowsArray,we=W.state.version,Oe=Se.getParameters(T,W.state,fe,z,K),Ie=Se.getProgramCacheKey(Oe);let $e=Z.programs;Z.environment=T.isMeshStandardMaterial?z.environment:null,Z.fog=z.fog,Z.envMap=(T.isMeshStandardMaterial?Q:w).get(T.envMap||Z.environment),Z.envMapRotation=Z.environment!==null&&T.envMap===null?z.environmentRotation:T.envMapRotation,$e===void 0&&(T.addEventListener("dispose",Je),$e=new Map,Z.programs=$e);let Xe=$e.get(Ie);if(Xe!==void 0){if(Z.currentProgram===Xe&&Z.lightsStateVersion===we)return hi(T,Oe),Xe}else Oe.uniforms=Se.getUniforms(T),T.onBeforeCompile(Oe,x),Xe=Se.acquireProgram(Oe,Ie),$e.set(Ie,Xe),Z.uniforms=Oe.uniforms;const Ue=Z.uniforms;return(!T.isShaderMaterial&&!T.isRawShaderMaterial||T.clipping===!0)&&(Ue.clippingPlanes=pe.uniform),hi(T,Oe),Z.needsLights=Ir(T),Z.lightsStateVersion=we,Z.needsLights&&(Ue.ambientLightColor.value=W.state.ambient,Ue.lightProbe.value=W.state.probe,Ue.directionalLights.value=W.state.directional,Ue.directionalLightShadows.value=W.state.directionalShadow,Ue.spotLights.value=W.state.spot,Ue.spotLightShadows.value=W.state.spotShadow,Ue.rectAreaLights.value=W.state.rectArea,Ue.ltc_1.value=W.state.rectAreaLTC1,Ue.ltc_2.value=W.state.rectAreaLTC2,Ue.pointLights.value=W.state.point,Ue.pointLightShadows.value=W.state.pointShadow,Ue.hemisphereLights.value=W.state.hemi,Ue.directionalShadowMap.value=W.state.directionalShadowMap,Ue.directionalShadowMatrix.value=W.state.directionalShadowMatrix,Ue.spotShadowMap.value=W.state.spotShadowMap,Ue.spotLightMatrix.value=W.state.spotLightMatrix,Ue.spotLightMap.value=W.state.spotLightMap,Ue.pointShadowMap.value=W.state.pointShadowMap,Ue.pointShadowMatrix.value=W.state.pointShadowMatrix),Z.currentProgram=Xe,Z.uniformsList=null,Xe}function Dr(T){if(T.uniformsList===null){const z=T.currentProgram.getUniforms();T.uniformsList=Ea.seqWithValue(z.seq,T.uniforms)}return T.uniformsList}function hi(T,z){const K=Ne.get(T);K.outputColorSpace=z.outputColorSpace,K.batching=z.batching,K.batchingColor=z.batchingColor,K.instancing=z.instancing,K.instancingColor=z.instancingColor,K.instancingMorph=z.instancingMorph,K.skinning=z.skinning,K.morphTargets=z.morphTargets,K.morphNormals=z.morphNormals,K.morphColors=z.morphColors,K.morphTargetsCount=z.morphTargetsCount,K.numClippingPlanes=z.numClippingPlanes,K.numIntersection=z.numClipIntersection,K.vertexAlphas=z.vertexAlphas,K.vertexTangents=z.vertexTangents,K.toneMapping=z.toneMapping}function Ja(T,z,K,Z,W){z.isScene!==!0&&(z=ct),L.resetTextureUnits();const fe=z.fog,we=Z.isMeshStandardMaterial?z.environment:null,Oe=I===null?x.outputColorSpace:I.isXRRenderTarget===!0?I.texture.colorSpace:qo,Ie=(Z.isMeshStandardMaterial?Q:w).get(Z.envMap||we),$e=Z.vertexColors===!0&&!!K.attributes.color&&K.attributes.color.itemSize===4,Xe=!!K.attributes.tangent&&(!!Z.normalMap||Z.anisotropy>0),Ue=!!K.morphAttributes.position,rt=!!K.morphAttributes.normal,wt=!!K.morphAttributes.color;let Tt=hs;Z.toneMapped&&(I===null||I.isXRRenderTarget===!0)&&(Tt=x.toneMapping);const sn=K.morphAttributes.position||K.morphAttributes.normal||K.morphAttributes.color,ut=sn!==void 0?sn.length:0,ze=Ne.get(Z),Ot=f.state.lights;if(ue===!0&&(ve===!0||T!==y)){const vn=T===y&&Z.id===E;pe.setState(Z,T,vn)}let mt=!1;Z.version===ze.__version?(ze.needsLights&&ze.lightsStateVersion!==Ot.state.version||ze.outputColorSpace!==Oe||W.isBatchedMesh&&ze.batching===!1||!W.isBatchedMesh&&ze.batching===!0||W.isBatchedMesh&&ze.batchingColor===!0&&W.colorTexture===null||W.isBatchedMesh&&ze.batchingColor===!1&&W.colorTexture!==null||W.isInstancedMesh&&ze.instancing===!1||!W.isInstancedMesh&&ze.instancing===!0||W.isSkinnedMesh&&ze.skinning===!1||!W.isSkinnedMesh&&ze.skinning===!0||W.isInstancedMesh&&ze.instancingColor===!0&&W.instanceColor===null||W.isInstancedMesh&&ze.instancingColor===!1&&W.instanceColor!==null||W.isInstancedMesh&&ze.instancingMorph===!0&&W.morphTexture===null||W.isInstancedMesh&&ze.instancingMorph===!1&&W.morphTexture!==null||ze.envMap!==Ie||Z.fog===!0&&ze.fog!==fe||ze.numClippingPlanes!==void 0&&(ze.numClippingPlanes!==pe.numPlanes||ze.numIntersection!==pe.numIntersection)||ze.vertexAlphas!==$e||ze.vertexTangents!==Xe||ze.morphTargets!==Ue||ze.morphNormals!==rt||ze.morphColors!==wt||ze.toneMapping!==Tt||ze.morphTargetsCount!==ut)&&(mt=!0):(mt=!0,ze.__version=Z.version);let An=ze.currentProgram;mt===!0&&(An=js(Z,z,W));let ui=!1,pn=!1,xs=!1;const Ct=An.getUniforms(),Hn=ze.uniforms;if(We.useProgram(An.program)&&(ui=!0,pn=!0,xs=!0),Z.id!==E&&(E=Z.id,pn=!0),ui||y!==T){We.buffers.depth.getReversed()?(ce.copy(T.projectionMatrix),oC(ce),rC(ce),Ct.setValue(G,"projectionMatrix",ce)):Ct.setValue(G,"projectionMatrix",T.projectionMatrix),Ct.setValue(G,"viewMatrix",T.matrixWorldInverse);const di=Ct.map.cameraPosition;di!==void 0&&di.setValue(G,Ge.setFromMatrixPosition(T.matrixWorld)),nt.logarithmicDepthBuffer&&Ct.setValue(G,"logDepthBufFC",2/(Math.log(T.far+1)/Math.LN2)),(Z.isMeshPhongMaterial||Z.isMeshToonMaterial||Z.isMeshLambertMaterial||Z.isMeshBasicMaterial||Z.isMeshStandardMaterial||Z.isShaderMaterial)&&Ct.setValue(G,"isOrthographic",T.isOrthographicCamera===!0),y!==T&&(y=T,pn=!0,xs=!0)}if(W.isSkinnedMesh){Ct.setOptional(G,W,"bindMatrix"),Ct.setOptional(G,W,"bindMatrixInverse");const vn=W.skeleton;vn&&(vn.boneTexture===null&&vn.computeBoneTexture(),Ct.setValue(G,"boneTexture",vn.boneTexture,L))}W.isBatchedMesh&&(Ct.setOptional(G,W,"batchingTexture"),Ct.setValue(G,"batchingTexture",W._matricesTexture,L),Ct.setOptional(G,W,"batchingIdTexture"),Ct.setValue(G,"batchingIdTexture",W._indirectTexture,L),Ct.setOptional(G,W,"batchingColorTexture"),W._colorsTexture!==null&&Ct.setValue(G,"batchingColorTexture",W._colorsTexture,L));const qi=K.morphAttributes;if((qi.position!==void 0||qi.normal!==void 0||qi.color!==void 0)&&Be.update(W,K,An),(pn||ze.receiveShadow!==W.receiveShadow)&&(ze.receiveShadow=W.receiveShadow,Ct.setValue(G,"receiveShadow",W.receiveShadow)),Z.isMeshGouraudMaterial&&Z.envMap!==null&&(Hn.envMap.value=Ie,Hn.flipEnvMap.value=Ie.isCubeTexture&&Ie.isRenderTargetTexture===!1?-1:1),Z.isMeshStandardMaterial&&Z.envMap===null&&z.environment!==null&&(Hn.envMapIntensity.value=z.environmentIntensity),pn&&(Ct.setValue(G,"toneMappingExposure",x.toneMappingExposure),ze.needsLights&&vs(Hn,xs),fe&&Z.fog===!0&&xe.refreshFogUniforms(Hn,fe),xe.refreshMaterialUniforms(Hn,Z,te,Y,f.state.transmissionRenderTarget[T.id]),Ea.upload(G,Dr(ze),Hn,L)),Z.isShaderMaterial&&Z.uniformsNeedUpdate===!0&&(Ea.upload(G,Dr(ze),Hn,L),Z.uniformsNeedUpdate=!1),Z.isSpriteMaterial&&Ct.setValue(G,"center",W.center),Ct.setValue(G,"modelViewMatrix",W.modelViewMatrix),Ct.setValue(G,"normalMatrix",W.normalMatrix),Ct.setValue(G,"modelMatrix",W.matrixWorld),Z.isShaderMaterial||Z.isRawShaderMaterial){const vn=Z.uniformsGroups;for(let di=0,Zn=vn.length;di<Zn;di++){const Ys=vn[di];H.update(Ys,An),H.bind(Ys,An)}}return An}function vs(T,z){T.ambientLightColor.needsUpdate=z,T.lightProbe.needsUpdate=z,T.directionalLights.needsUpdate=z,T.directionalLightShadows.needsUpdate=z,T.pointLights.needsUpdate=z,T.pointLightShadows.needsUpdate=z,T.spotLights.needsUpdate=z,T.spotLightShadows.needsUpdate=z,T.rectAreaLights.needsUpdate=z,T.hemisphereLights.needsUpdate=z}function Ir(T){return T.isMeshLambertMaterial||T.isMeshToonMaterial||T.isMeshPhongMaterial||T.isMeshStandardMaterial||T.isShadowMaterial||T.isShaderMaterial&&T.lights===!0}this.getActiveCubeFace=function(){return P},this.getActiveMipmapLevel=function(){return A},this.getRenderTarget=function(){return I},this.setRenderTargetTextures=function(T,z,K){Ne.get(T.texture).__webglTexture=z,Ne.get(T.depthTexture).__webglTexture=K;const Z=Ne.get(T);Z.__hasExternalTextures=!0,Z.__autoAllocateDepthBuffer=K===void 0,Z.__autoAllocateDepthBuffer||et.has("WEBGL_multisampled_render_to_texture")===!0&&(console.warn("THREE.WebGLRenderer: Render-to-texture extension was disabled because an external texture was provided"),Z.__useRenderToTexture=!1)},this.setRenderTargetFramebuffer=function(T,z){const K=Ne.get(T);K.__webglFramebuffer=z,K.__useDefaultFramebuffer=z===void 0},this.setRenderTarget=function(T,z=0,K=0){I=T,P=z,A=K;let Z=!0,W=null,fe=!1,we=!1;if(T){const Ie=Ne.get(T);if(Ie.__useDefaultFramebuffer!==void 0)We.bindFramebuffer(G.FRAMEBUFFER,null),Z=!1;else if(Ie.__webglFramebuffer===void 0)L.setupRenderTarget(T);else if(Ie.__hasExternalTextures)L.rebindTextures(T,Ne.get(T.texture).__webglTexture,Ne.get(T.depthTexture).__webglTexture);else if(T.depthBuffer){const Ue=T.depthTexture;if(Ie.__boundDepthTexture!==Ue){if(Ue!==null&&Ne.has(Ue)&&(T.width!==Ue.image.width||T.height!==Ue.image.height))throw new Error("WebGLRenderTarget: Attached DepthTexture is initialized to the incorrect size.");L.setupDepthRenderbuffer(T)}}const $e=T.texture;($e.isData3DTexture||$e.isDataArrayTexture||$e.isCompressedArrayTexture)&&(we=!0);const Xe=Ne.get(T).__webglFramebuffer;T.isWebGLCubeRenderTarget?(Array.isArray(Xe[z])?W=Xe[z][K]:W=Xe[z],fe=!0):T.samples>0&&L.useMultisampledRTT(T)===!1?W=Ne.get(T).__webglMultisampledFramebuffer:Array.isArray(Xe)?W=Xe[K]:W=Xe,R.copy(T.viewport),V.copy(T.scissor),O=T.scissorTest}else R.copy(_e).multiplyScalar(te).floor(),V.copy(Me).multiplyScalar(te).floor(),O=ge;if(We.bindFramebuffer(G.FRAMEBUFFER,W)&&Z&&We.drawBuffers(T,W),We.viewport(R),We.scissor(V),We.setScissorTest(O),fe){const Ie=Ne.get(T.texture);G.framebufferTexture2D(G.FRAMEBUFFER,G.COLOR_ATTACHMENT0,G.TEXTURE_CUBE_MAP_POSITIVE_X+z,Ie.__webglTexture,K)}else if(we){const Ie=Ne.get(T.texture),$e=z||0;G.framebufferTextureLayer(G.FRAMEBUFFER,G.COLOR_ATTACHMENT0,Ie.__webglTexture,K||0,$e)}E=-1},this.readRenderTargetPixels=function(T,z,K,Z,W,fe,we){if(!(T&&T.isWebGLRenderTarget)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Oe=Ne.get(T).__webglFramebuffer;if(T.isWebGLCubeRenderTarget&&we!==void 0&&(Oe=Oe[we]),Oe){We.bindFramebuffer(G.FRAMEBUFFER,Oe);try{const Ie=T.texture,$e=Ie.format,Xe=Ie.type;if(!nt.textureFormatReadable($e)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(!nt.textureTypeReadable(Xe)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}z>=0&&z<=T.width-Z&&K>=0&&K<=T.height-W&&G.readPixels(z,K,Z,W,je.convert($e),je.convert(Xe),fe)}finally{const Ie=I!==null?Ne.get(I).__webglFramebuffer:null;We.bindFramebuffer(G.FRAMEBUFFER,Ie)}}},this.readRenderTargetPixelsAsync=async function(T,z,K,Z,W,fe,we){if(!(T&&T.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Oe=Ne.get(T).__webglFramebuffer;if(T.isWebGLCubeRenderTarget&&we!==void 0&&(Oe=Oe[we]),Oe){const Ie=T.texture,$e=Ie.format,Xe=Ie.type;if(!nt.textureFormatReadable($e))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(!nt.textureTypeReadable(Xe))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");if(z>=0&&z<=T.width-Z&&K>=0&&K<=T.height-W){We.bindFramebuffer(G.FRAMEBUFFER,Oe);const Ue=G.createBuffer();G.bindBuffer(G.PIXEL_PACK_BUFFER,Ue),G.bufferData(G.PIXEL_PACK_BUFFER,fe.byteLength,G.STREAM_READ),G.readPixels(z,K,Z,W,je.convert($e),je.convert(Xe),0);const rt=I!==null?Ne.get(I).__webglFramebuffer:null;We.bindFramebuffer(G.FRAMEBUFFER,rt);const wt=G.fenceSync(G.SYNC_GPU_COMMANDS_COMPLETE,0);return G.flush(),await sC(G,wt,4),G.bindBuffer(G.PIXEL_PACK_BUFFER,Ue),G.getBufferSubData(G.PIXEL_PACK_BUFFER,0,fe),G.deleteBuffer(Ue),G.deleteSync(wt),fe}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")}},this.copyFramebufferToTexture=function(T,z=null,K=0){T.isTexture!==!0&&(pr("WebGLRenderer: copyFramebufferToTexture function signature has changed."),z=arguments[0]||null,T=arguments[1]);const Z=Math.pow(2,-K),W=Math.floor(T.image.width*Z),fe=Math.floor(T.image.height*Z),we=z!==null?z.x:0,Oe=z!==null?z.y:0;L.setTexture2D(T,0),G.copyTexSubImage2D(G.TEXTURE_2D,K,0,0,we,Oe,W,fe),We.unbindTexture()},this.copyTextureToTexture=function(T,z,K=null,Z=null,W=0){T.isTexture!==!0&&(pr("WebGLRenderer: copyTextureToTexture function signature has changed."),Z=arguments[0]||null,T=arguments[1],z=arguments[2],W=arguments[3]||0,K=null);let fe,we,Oe,Ie,$e,Xe,Ue,rt,wt;const Tt=T.isCompressedTexture?T.mipmaps[W]:T.image;K!==null?(fe=K.max.x-K.min.x,we=K.max.y-K.min.y,Oe=K.isBox3?K.max.z-K.min.z:1,Ie=K.min.x,$e=K.min.y,Xe=K.isBox3?K.min.z:0):(fe=Tt.width,we=Tt.height,Oe=Tt.depth||1,Ie=0,$e=0,Xe=0),Z!==null?(Ue=Z.x,rt=Z.y,wt=Z.z):(Ue=0,rt=0,wt=0);const sn=je.convert(z.format),ut=je.convert(z.type);let ze;z.isData3DTexture?(L.setTexture3D(z,0),ze=G.TEXTURE_3D):z.isDataArrayTexture||z.isCompressedArrayTexture?(L.setTexture2DArray(z,0),ze=G.TEXTURE_2D_ARRAY):(L.setTexture2D(z,0),ze=G.TEXTURE_2D),G.pixelStorei(G.UNPACK_FLIP_Y_WEBGL,z.flipY),G.pixelStorei(G.UNPACK_PREMULTIPLY_ALPHA_WEBGL,z.premultiplyAlpha),G.pixelStorei(G.UNPACK_ALIGNMENT,z.unpackAlignment);const Ot=G.getParameter(G.UNPACK_ROW_LENGTH),mt=G.getParameter(G.UNPACK_IMAGE_HEIGHT),An=G.getParameter(G.UNPACK_SKIP_PIXELS),ui=G.getParameter(G.UNPACK_SKIP_ROWS),pn=G.getParameter(G.UNPACK_SKIP_IMAGES);G.pixelStorei(G.UNPACK_ROW_LENGTH,Tt.width),G.pixelStorei(G.UNPACK_IMAGE_HEIGHT,Tt.height),G.pixelStorei(G.UNPACK_SKIP_PIXELS,Ie),G.pixelStorei(G.UNPACK_SKIP_ROWS,$e),G.pixelStorei(G.UNPACK_SKIP_IMAGES,Xe);const xs=T.isDataArrayTexture||T.isData3DTexture,Ct=z.isDataArrayTexture||z.isData3DTexture;if(T.isRenderTargetTexture||T.isDepthTexture){const Hn=Ne.get(T),qi=Ne.get(z),vn=Ne.get(Hn.__renderTarget),di=Ne.get(qi.__renderTarget);We.bindFramebuffer(G.READ_FRAMEBUFFER,vn.__webglFramebuffer),We.bindFramebuffer(G.DRAW_FRAMEBUFFER,di.__webglFramebuffer);for(let Zn=0;Zn<Oe;Zn++)xs&&G.framebufferTextureLayer(G.READ_FRAMEBUFFER,G.COLOR_ATTACHMENT0,Ne.get(T).__webglTexture,W,Xe+Zn),T.isDepthTexture?(Ct&&G.framebufferTextureLayer(G.DRAW_FRAMEBUFFER,G.COLOR_ATTACHMENT0,Ne.get(z).__webglTexture,W,wt+Zn),G.blitFramebuffer(Ie,$e,fe,we,Ue,rt,fe,we,G.DEPTH_BUFFER_BIT,G.NEAREST)):Ct?G.copyTexSubImage3D(ze,W,Ue,rt,wt+Zn,Ie,$e,fe,we):G.copyTexSubImage2D(ze,W,Ue,rt,wt+Zn,Ie,$e,fe,we);We.bindFramebuffer(G.READ_FRAMEBUFFER,null),We.bindFramebuffer(G.DRAW_FRAMEBUFFER,null)}else Ct?T.isDataTexture||T.isData3DTexture?G.texSubImage3D(ze,W,Ue,rt,wt,fe,we,Oe,sn,ut,Tt.data):z.isCompressedArrayTexture?G.compressedTexSubImage3D(ze,W,Ue,rt,wt,fe,we,Oe,sn,Tt.data):G.texSubImage3D(ze,W,Ue,rt,wt,fe,we,Oe,sn,ut,Tt):T.isDataTexture?G.texSubImage2D(G.TEXTURE_2D,W,Ue,rt,fe,we,sn,ut,Tt.data):T.isCompressedTexture?G.compressedTexSubImage2D(G.TEXTURE_2D,W,Ue,rt,Tt.width,Tt.height,sn,Tt.data):G.texSubImage2D(G.TEXTURE_2D,W,Ue,rt,fe,we,sn,ut,Tt);G.pixelStorei(G.UNPACK_ROW_LENGTH,Ot),G.pixelStorei(G.UNPACK_IMAGE_HEIGHT,mt),G.pixelStorei(G.UNPACK_SKIP_PIXELS,An),G.pixelStorei(G.UNPACK_SKIP_ROWS,ui),G.pixelStorei(G.UNPACK_SKIP_IMAGES,pn),W===0&&z.generateMipmaps&&G.generateMipmap(ze),We.unbindTexture()},this.copyTextureToTexture3D=function(T,z,K=null,Z=null,W=0){return T.isTexture!==!0&&(pr("WebGLRenderer: copyTextureToTexture3D function signature has changed."),K=arguments[0]||null,Z=arguments[1]||null,T=arguments[2],z=arguments[3],W=arguments[4]||0),pr('WebGLRenderer: copyTextureToTexture3D function has been deprecated. Use "copyTextureToTexture" instead.'),this.copyTextureToTexture(T,z,K,Z,W)},this.initRenderTarget=function(T){Ne.get(T).__webglFramebuffer===void 0&&L.setupRenderTarget(T)},this.initTexture=function(T){T.isCubeTexture?L.setTextureCube(T,0):T.isData3DTexture?L.setTexture3D(T,0):T.isDataArrayTexture||T.isCompressedArrayTexture?L.setTexture2DArray(T,0):L.setTexture2D(T,0),We.unbindTexture()},this.resetState=function(){P=0,A=0,I=null,We.reset(),pt.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Bi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;const t=this.getContext();t.drawingBufferColorspace=gt._getDrawingBufferColorSpace(e),t.unpackColorSpace=gt._getUnpackColorSpace()}}class Vh{constructor(e,t=1,n=1e3){this.isFog=!0,this.name="",this.color=new dt(e),this.near=t,this.far=n}clone(){return new Vh(this.color,this.near,this.far)}toJSON(){return{type:"Fog",name:this.name,color:this.color.getHex(),near:this.near,far:this.far}}}class gD extends dn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Ei,this.environmentIntensity=1,this.environmentRotation=new Ei,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),e.background!==null&&(this.background=e.background.clone()),e.environment!==null&&(this.environment=e.environment.clone()),e.fog!==null&&(this.fog=e.fog.clone()),this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),e.overrideMaterial!==null&&(this.overrideMaterial=e.overrideMaterial.clone()),this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){const t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),this.backgroundBlurriness>0&&(t.object.backgroundBlurriness=this.backgroundBlurriness),this.backgroundIntensity!==1&&(t.object.backgroundIntensity=this.backgroundIntensity),t.object.backgroundRotation=this.backgroundRotation.toArray(),this.environmentIntensity!==1&&(t.object.environmentIntensity=this.environmentIntensity),t.object.environmentRotation=this.environmentRotation.toArray(),t}}class _D extends En{constructor(e,t,n,s,o,r,a,l,c){super(e,t,n,s,o,r,a,l,c),this.isCanvasTexture=!0,this.needsUpdate=!0}}class Ho extends gs{constructor(e=1,t=1,n=1,s=32,o=1,r=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:e,radiusBottom:t,height:n,radialSegments:s,heightSegments:o,openEnded:r,thetaStart:a,thetaLength:l};const c=this;s=Math.floor(s),o=Math.floor(o);const h=[],u=[],d=[],m=[];let g=0;const _=[],p=n/2;let f=0;M(),r===!1&&(e>0&&S(!0),t>0&&S(!1)),this.setIndex(h),this.setAttribute("position",new Si(u,3)),this.setAttribute("normal",new Si(d,3)),this.setAttribute("uv",new Si(m,2));function M(){const x=new ee,F=new ee;let P=0;const A=(t-e)/n;for(let I=0;I<=o;I++){const E=[],y=I/o,R=y*(t-e)+e;for(let V=0;V<=s;V++){const O=V/s,$=O*l+a,q=Math.sin($),X=Math.cos($);F.x=R*q,F.y=-y*n+p,F.z=R*X,u.push(F.x,F.y,F.z),x.set(q,A,X).normalize(),d.push(x.x,x.y,x.z),m.push(O,1-y),E.push(g++)}_.push(E)}for(let I=0;I<s;I++)for(let E=0;E<o;E++){const y=_[E][I],R=_[E+1][I],V=_[E+1][I+1],O=_[E][I+1];(e>0||E!==0)&&(h.push(y,R,O),P+=3),(t>0||E!==o-1)&&(h.push(R,V,O),P+=3)}c.addGroup(f,P,0),f+=P}function S(x){const F=g,P=new vt,A=new ee;let I=0;const E=x===!0?e:t,y=x===!0?1:-1;for(let V=1;V<=s;V++)u.push(0,p*y,0),d.push(0,y,0),m.push(.5,.5),g++;const R=g;for(let V=0;V<=s;V++){const $=V/s*l+a,q=Math.cos($),X=Math.sin($);A.x=E*X,A.y=p*y,A.z=E*q,u.push(A.x,A.y,A.z),d.push(0,y,0),P.x=q*.5+.5,P.y=X*.5*y+.5,m.push(P.x,P.y),g++}for(let V=0;V<s;V++){const O=F+V,$=R+V;x===!0?h.push($,$+1,O):h.push($+1,$,O),I+=3}c.addGroup(f,I,x===!0?1:2),f+=I}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new Ho(e.radiusTop,e.radiusBottom,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}}class Dm extends Lr{static get type(){return"MeshStandardMaterial"}constructor(e){super(),this.isMeshStandardMaterial=!0,this.defines={STANDARD:""},this.color=new dt(16777215),this.roughness=1,this.metalness=0,this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new dt(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=pm,this.normalScale=new vt(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.roughnessMap=null,this.metalnessMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ei,this.envMapIntensity=1,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.defines={STANDARD:""},this.color.copy(e.color),this.roughness=e.roughness,this.metalness=e.metalness,this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.roughnessMap=e.roughnessMap,this.metalnessMap=e.metalnessMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.envMapIntensity=e.envMapIntensity,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}}class Gh extends dn{constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new dt(e),this.intensity=t}dispose(){}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){const t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,this.groundColor!==void 0&&(t.object.groundColor=this.groundColor.getHex()),this.distance!==void 0&&(t.object.distance=this.distance),this.angle!==void 0&&(t.object.angle=this.angle),this.decay!==void 0&&(t.object.decay=this.decay),this.penumbra!==void 0&&(t.object.penumbra=this.penumbra),this.shadow!==void 0&&(t.object.shadow=this.shadow.toJSON()),this.target!==void 0&&(t.object.target=this.target.uuid),t}}class vD extends Gh{constructor(e,t,n){super(e,n),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(dn.DEFAULT_UP),this.updateMatrix(),this.groundColor=new dt(t)}copy(e,t){return super.copy(e,t),this.groundColor.copy(e.groundColor),this}}const Jl=new zt,Af=new ee,Rf=new ee;class xD{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new vt(512,512),this.map=null,this.mapPass=null,this.matrix=new zt,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new zh,this._frameExtents=new vt(1,1),this._viewportCount=1,this._viewports=[new Gt(0,0,1,1)]}getViewportCount(){return this._viewportCount}getFrustum(){return this._frustum}updateMatrices(e){const t=this.camera,n=this.matrix;Af.setFromMatrixPosition(e.matrixWorld),t.position.copy(Af),Rf.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(Rf),t.updateMatrixWorld(),Jl.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),this._frustum.setFromProjectionMatrix(Jl),n.set(.5,0,0,.5,0,.5,0,.5,0,0,.5,.5,0,0,0,1),n.multiply(Jl)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.mapSize.copy(e.mapSize),this}clone(){return new this.constructor().copy(this)}toJSON(){const e={};return this.intensity!==1&&(e.intensity=this.intensity),this.bias!==0&&(e.bias=this.bias),this.normalBias!==0&&(e.normalBias=this.normalBias),this.radius!==1&&(e.radius=this.radius),(this.mapSize.x!==512||this.mapSize.y!==512)&&(e.mapSize=this.mapSize.toArray()),e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}}class bD extends xD{constructor(){super(new Am(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}}class yD extends Gh{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(dn.DEFAULT_UP),this.updateMatrix(),this.target=new dn,this.shadow=new bD}dispose(){this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}}class MD extends Gh{constructor(e,t){super(e,t),this.isAmbientLight=!0,this.type="AmbientLight"}}const Cf=new zt;class SD{constructor(e,t,n=0,s=1/0){this.ray=new xm(e,t),this.near=n,this.far=s,this.camera=null,this.layers=new Oh,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(e,t){this.ray.set(e,t)}setFromCamera(e,t){t.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(e.x,e.y,.5).unproject(t).sub(this.ray.origin).normalize(),this.camera=t):t.isOrthographicCamera?(this.ray.origin.set(e.x,e.y,(t.near+t.far)/(t.near-t.far)).unproject(t),this.ray.direction.set(0,0,-1).transformDirection(t.matrixWorld),this.camera=t):console.error("THREE.Raycaster: Unsupported camera type: "+t.type)}setFromXRController(e){return Cf.identity().extractRotation(e.matrixWorld),this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(Cf),this}intersectObject(e,t=!0,n=[]){return th(e,this,n,t),n.sort(Pf),n}intersectObjects(e,t=!0,n=[]){for(let s=0,o=e.length;s<o;s++)th(e[s],this,n,t);return n.sort(Pf),n}}function Pf(i,e){return i.distance-e.distance}function th(i,e,t,n){let s=!0;if(i.layers.test(e.layers)&&i.raycast(e,t)===!1&&(s=!1),s===!0&&n===!0){const o=i.children;for(let r=0,a=o.length;r<a;r++)th(o[r],e,t,!0)}}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:Ph}}));typeof window<"u"&&(window.__THREE__?console.warn("WARNING: Multiple instances of Three.js being imported."):window.__THREE__=Ph);function wD(i,e){return-i*e*1.55}const ED=.3,Lf=.8;function Im(i){return i.body_height+2*i.wheel_radius}function Um(i,e){const t=i/Im(e)*ED*e.weight;return Math.max(-Lf*e.weight,Math.min(Lf*e.weight,t))}const TD=120,yo=.1,Fa=60,Nf=1920;class AD{constructor(e,t,n){this.look=e,this.own=t;const s=(o,r=.7,a=0)=>{const l=new Dm({color:o,roughness:r,metalness:a});return n&&(l.color.set(t),l.transparent=!0,l.opacity=.3),l};this.build(s,!n),this.root.add(this.body,...this.wheels),this.body.position.y=e.wheel_radius,this.root.traverse(o=>{o instanceof un&&(o.castShadow=o.receiveShadow=!n)})}root=new yi;body=new yi;wheels=[new yi,new yi];x=0;z=0;last=null;build(e,t){const{wheel_radius:n,track:s,body_height:o,body_depth:r}=this.look,a=Math.max(s*.62,.02),l=n*.25,c=(u,d,m,g,_,p,f)=>{const M=new un(new $s(m,d,u),g);M.position.set(_,p,f),this.body.add(M)},h=e(this.own,.55);if(c(a,o*.94,r,h,0,l+o*.5,0),t&&c(s*.8,n*.5,r*.55,e("#3b424a",.6),0,0,0),t&&this.look.command_unit!=="V")for(const u of[.22,.5,.78])c(a*1.01,o*.03,r*1.02,e("#20262c",.6),0,l+o*u,0);else if(t){c(a*.72,o*.26,r*.04,e("#20262c",.25),r*.5,l+o*.72,0),c(a*.62,o*.18,r*.05,e("#b9d8c4",.3),r*.505,l+o*.73,0),c(a*.16,o*.08,r*.08,e("#f4f5f6",.5),r*.5,l+o*.42,0);for(const u of[-1,1])c(a*.14,o*.06,r*.07,e("#8b949d",.5),r*.5,l+o*.42,u*a*.22)}if(this.look.payload>0&&t){const u=Math.cbrt(this.look.payload/2500),d=this.look.payload_height-u/2-l;d>0&&c(.008,d,.008,e("#5c656e",.6),0,l+d/2,0),c(u,u,u,e("#8c5a2b",.8),0,this.look.payload_height,0)}this.wheels.forEach((u,d)=>this.tyre(u,d===0?-s/2:s/2,e,t))}tyre(e,t,n,s){const o=this.look.wheel_radius,r=Math.min(this.look.track*.16,o*.7),a=new un(new Ho(o,o,r,40),n("#23272c",.95)),l=new un(new Ho(o*.66,o*.66,r*1.04,32),n("#c9ced3",.45,.1));a.rotation.x=l.rotation.x=Math.PI/2,e.add(a),s&&e.add(l);for(let c=0;s&&c<3;c+=1){const h=new un(new $s(o*1.2,o*.13,r*1.1),n("#5c656e",.6));h.rotation.z=c*Math.PI/3,e.add(h)}e.position.set(0,o,t)}move(e,t){const{wheel_radius:n,track:s}=this.look,[o,,r,,a]=e;if(this.last!==null){const c=n*(r-this.last);this.x+=c*Math.cos(a),this.z-=c*Math.sin(a)}this.last=r,this.root.rotation.y=a,this.root.position.set(this.x+t*Math.sin(a),0,this.z+t*Math.cos(a)),this.body.rotation.z=-o;const l=s/(2*n)*a;this.wheels[0].rotation.z=-(r-l),this.wheels[1].rotation.z=-(r+l)}shift(e,t){this.x+=e,this.z+=t}start(e){e&&([this.x,this.z,this.last]=[e.x,e.z,e.last])}}function RD(i){const e=document.createElement("canvas");e.width=e.height=128;const t=e.getContext("2d");t.fillStyle=i?"#252b32":"#eeeeec",t.fillRect(0,0,128,128),t.strokeStyle=i?"#39424b":"#cfd1d2",t.lineWidth=2,t.strokeRect(0,0,128,128);const n=new _D(e);return n.wrapS=n.wrapT=Ia,n.repeat.set(Fa,Fa),n.anisotropy=8,n.colorSpace=On,n}class CD{constructor(e,t){this.canvas=e,this.push=t,this.element=e,this.renderer=new mD({canvas:e,antialias:!0}),this.renderer.shadowMap.enabled=!0,this.renderer.shadowMap.type=tm,this.floor=new un(new Nr(Fa*yo,Fa*yo),new Dm({roughness:.95})),this.floor.rotation.x=-Math.PI/2,this.floor.receiveShadow=!0,this.sun.castShadow=!0,this.sun.shadow.mapSize.set(1024,1024),this.sun.shadow.radius=6,this.sun.shadow.bias=-5e-4,this.shaft=new un(new Ho(1,1,1,16),this.ink),this.head=new un(new Ho(0,1,1,24),this.ink),this.arrow.add(this.shaft,this.head),this.arrow.visible=!1,this.ground.add(this.floor,this.arrow),this.scene.add(this.ground,this.sky,this.sun,this.sun.target,new MD("#ffffff",.35)),this.paint(),this.listen()}renderer;scene=new gD;camera=new Yn(32,1,.02,30);sun=new yD("#fffdf8",2.4);sky=new vD("#ffffff","#c4c6c8",1.1);floor;ground=new yi;figures=[];bodies=[];look=null;arrow=new yi;shaft;head;ink=new Bh;eye={azimuth:.5,height:.26,away:1};grip=null;turning=null;centre=new ee;calm=matchMedia("(prefers-reduced-motion: reduce)");slow=0;detail=1;seen=-1;stale=!0;element;paint(){const e=document.documentElement.dataset.theme==="dark";this.ink.color.set(fs().push);const t=new dt(e?"#1b2026":"#f4f3ef");this.scene.background=t,this.scene.fog=new Vh(t,1.2*this.size()+1.2,3*this.size()+2.2),this.floor.material.map=RD(e),this.floor.material.needsUpdate=!0,this.sun.intensity=e?1.7:1.9,this.stale=!0,this.sky.intensity=e?.7:1;const[n,s]=[this.look,this.bodies];n&&this.furnish(n,s)}furnish(e,t){const n=new Map(this.bodies.map((a,l)=>[a,this.figures[l]]));for(const a of this.figures)this.ground.remove(a.root);const s=this.look===null;this.look=e,this.bodies=t,this.seen=-1,this.stale=!0,this.figures=t.map((a,l)=>new AD(e,ls(a),l>0)),this.figures.forEach((a,l)=>a.start(n.get(t[l])));for(const a of this.figures)this.ground.add(a.root);const o=this.size(),r=o*2.2;Object.assign(this.sun.shadow.camera,{left:-r,right:r,top:r,bottom:-r,near:.01,far:o*12}),this.sun.shadow.camera.updateProjectionMatrix(),s&&this.paint()}size(){return this.look?Math.max(Im(this.look),this.look.payload>0?1.1*(this.look.payload_height+this.look.wheel_radius):0):.25}move(e){if(!this.look||e.x.length!==this.figures.length||e.n===this.seen)return;this.seen=e.n,this.stale=!0;const t=this.look.track;this.ground.rotation.z=e.f[2],this.figures.forEach((s,o)=>s.move(e.x[o],wD(o,t)));const n=this.figures[0];if(Math.hypot(n.x,n.z)>3){const s=a=>-Math.round(a/yo)*yo,[o,r]=[s(n.x),s(n.z)];for(const a of this.figures)a.shift(o,r);this.centre.add(new ee(o,0,r))}this.show(e.f[0],e.f[1],e.x[0][0],e.x[0][4])}show(e,t,n,s){const o=this.look,r=this.figures[0].root.position;if(this.arrow.visible=Math.abs(e)>.005,!this.arrow.visible)return;const a=Math.min(.04+Math.abs(e)/o.weight*this.size()*1.2,this.size()*1.6),l=new ee(Math.cos(s),0,-Math.sin(s)).multiplyScalar(Math.sign(e)),c=t*Math.sin(n),h=new ee(r.x+c*Math.cos(s),o.wheel_radius+t*Math.cos(n),r.z-c*Math.sin(s)),u=o.body_depth/2+.004;this.arrow.position.copy(h).addScaledVector(l,-a-u),this.arrow.quaternion.setFromUnitVectors(new ee(0,1,0),l);const[d,m]=[this.size()*.014,Math.min(a*.6,this.size()*.13)];this.shaft.scale.set(d,a-m,d),this.shaft.position.y=(a-m)/2,this.head.scale.set(3*d,m,3*d),this.head.position.y=a-m/2}draw(e){const{clientWidth:t,clientHeight:n}=this.canvas;if(!t||!n)return;this.pace(e);const s=Math.min(devicePixelRatio,2)*this.detail,o=this.renderer.getDrawingBufferSize(new vt);(Math.abs(o.x-t*s)>1||Math.abs(o.y-n*s)>1)&&(this.renderer.setPixelRatio(s),this.renderer.setSize(t,n,!1),this.camera.aspect=t/n,this.camera.updateProjectionMatrix(),this.stale=!0),this.stale&&(this.stale=this.follow(e),this.pull(),this.renderer.render(this.scene,this.camera))}pace(e){this.slow=e>45?this.slow+1:Math.max(0,this.slow-.5),this.slow>40&&this.detail>.8&&(this.detail*=.75,this.slow=0)}follow(e){const t=this.figures[0],n=this.size();t&&this.centre.lerp(new ee(t.x,0,t.z),this.calm.matches?1:1-Math.exp(-e/TD));const s=this.camera.aspect<1?1.25:1,o=n*3.5*this.eye.away*s,{azimuth:r,height:a}=this.eye,l=o*Math.cos(a);this.ground.updateMatrixWorld();const c=this.ground.localToWorld(this.centre.clone()),h=c.clone().setY(c.y+n*.42);this.camera.position.set(h.x+l*Math.sin(r),h.y+o*Math.sin(a),h.z+l*Math.cos(r)),this.camera.lookAt(h),this.sun.position.set(c.x-n*2,c.y+n*5,c.z+n*2.4),this.sun.target.position.copy(c);const u=d=>Math.round(d/yo)*yo;return this.floor.position.set(u(this.centre.x),0,u(this.centre.z)),t?Math.hypot(t.x-this.centre.x,t.z-this.centre.z)>.001:!1}picture(e){const{clientWidth:t,clientHeight:n}=this.canvas;this.renderer.setPixelRatio(Nf/t),this.renderer.setSize(t,n,!1),this.renderer.render(this.scene,this.camera);const{width:s,height:o}=this.canvas,[r,a]=[document.createElement("canvas"),Math.round(Nf/28)];Object.assign(r,{width:s,height:o+a});const l=r.getContext("2d"),c=getComputedStyle(document.documentElement);return l.fillStyle=c.getPropertyValue("--card"),l.fillRect(0,0,s,o+a),l.drawImage(this.canvas,0,0),Object.assign(l,{fillStyle:c.getPropertyValue("--ink"),font:`${.45*a}px system-ui, sans-serif`,textBaseline:"middle"}),l.fillText(e,.4*a,o+a/2,s-.8*a),this.stale=!0,this.draw(0),new Promise(h=>r.toBlob(h))}turn(e,t){this.stale=!0,this.eye.azimuth+=e,this.eye.height=Math.min(1.2,Math.max(.03,this.eye.height+t))}zoom(e){this.stale=!0,this.eye.away=Math.min(3,Math.max(.45,this.eye.away*e))}grasp(){const e=this.look;if(!e)return{x:0,y:0};const t=this.figures[0].body.localToWorld(new ee(0,e.body_height*.6,0)).project(this.camera);return{x:(t.x+1)/2*this.canvas.clientWidth,y:(1-t.y)/2*this.canvas.clientHeight}}pointer(e){const t=this.canvas.getBoundingClientRect();return new vt((e.clientX-t.left)/t.width*2-1,1-(e.clientY-t.top)/t.height*2)}ray(e){const t=new SD;return t.setFromCamera(e,this.camera),t}listen(){this.canvas.addEventListener("pointerdown",e=>this.down(e)),this.canvas.addEventListener("pointermove",e=>this.moved(e));for(const e of["pointerup","pointercancel","lostpointercapture"])this.canvas.addEventListener(e,()=>this.up());this.canvas.addEventListener("wheel",e=>{e.preventDefault(),this.zoom(Math.exp(e.deltaY/900))},{passive:!1})}down(e){if(!this.look||!this.figures.length)return;this.canvas.setPointerCapture(e.pointerId);const t=this.pointer(e),n=this.ray(t).intersectObject(this.figures[0].root,!0)[0];if(!n){this.turning={x:e.clientX,y:e.clientY};return}const s=this.figures[0].body.worldToLocal(n.point.clone());this.grip={at:s,mouse:t,height:Math.max(0,s.y)},this.pull(),this.canvas.classList.add("holding")}moved(e){this.turning&&(this.turn((this.turning.x-e.clientX)/160,(e.clientY-this.turning.y)/260),this.turning={x:e.clientX,y:e.clientY}),this.grip&&(this.grip.mouse=this.pointer(e),this.pull())}pull(){const[e,t]=[this.grip,this.look];if(!e||!t)return;const n=this.figures[0],s=n.body.localToWorld(e.at.clone()),o=this.camera.position.clone().sub(s).setY(0).normalize(),r=new rs().setFromNormalAndCoplanarPoint(o,s),a=this.ray(e.mouse).ray.intersectPlane(r,new ee);if(!a)return;const l=n.root.rotation.y,c=a.sub(s).dot(new ee(Math.cos(l),0,-Math.sin(l)).applyQuaternion(this.ground.quaternion));this.push({force:Um(c,t),height:e.height})}up(){this.turning=null,this.grip&&(this.grip=null,this.canvas.classList.remove("holding"),this.push({force:0,height:0}))}}const PD="http://www.w3.org/2000/svg",Mo=170,LD=110,Df=600;class ND{constructor(e){this.push=e,this.element.addEventListener("pointerdown",t=>this.down(t)),this.element.addEventListener("pointermove",t=>this.moved(t));for(const t of["pointerup","pointercancel"])this.element.addEventListener(t,()=>this.up())}element=$n("svg",{viewBox:"-200 0 400 200",class:"room flat",role:"img",tabindex:"0"});sides=[];ground=$n("g");arrow=$n("path",{class:"arrow"});look=null;grip=null;paint(){}furnish(e,t){this.look=e,this.element.replaceChildren(this.ground),this.ground.replaceChildren($n("line",{x1:-Df,x2:Df,y1:Mo,y2:Mo,class:"ground"})),this.sides=t.map((n,s)=>this.side(e,n,s>0)).reverse();for(const n of this.sides)this.ground.append(n.root);this.sides.reverse(),this.ground.append(this.arrow)}scale(e){return LD/(Math.max(e.body_height,e.payload>0?e.payload_height:0)+e.wheel_radius)}side(e,t,n){const s=this.scale(e),[o,r,a]=[e.wheel_radius*s,e.body_height*s,e.body_depth*s],l=n?{fill:"none",stroke:ls(t),"stroke-width":2,opacity:.7}:{},c=n?{}:{fill:ls(t)},h=$n("g");if(h.append($n("rect",{x:-a/2,y:-r-o*.25,width:a,height:r,rx:3,class:n?"":"shell",...l,...c})),e.payload>0&&!n){const[m,g]=[Math.cbrt(e.payload/2500)*s,e.payload_height*s];h.append($n("path",{d:`M0 0V${-g}`,class:"carrier"}),$n("rect",{x:-m/2,y:-g-m/2,width:m,height:m,class:"payload"}))}const u=$n("g");u.append($n("circle",{r:o,class:n?"":"tyre",...l}),$n("path",{d:`M${-o*.6} 0H${o*.6}M0 ${-o*.6}V${o*.6}`,class:n?"":"spokes",...l}));const d=$n("g");return d.append(h,u),{root:d,body:h,wheel:u}}move(e){const t=this.look;if(!t||e.x.length!==this.sides.length)return;const n=this.scale(t),s=180/Math.PI;this.ground.setAttribute("transform",`rotate(${-e.f[2]*s} 0 ${Mo})`),this.sides.forEach((u,d)=>{const[m,,g]=e.x[d],_=(g-e.x[0][2])*t.wheel_radius*n;u.root.setAttribute("transform",`translate(${_} ${Mo-t.wheel_radius*n})`),u.body.setAttribute("transform",`rotate(${m*s})`),u.wheel.setAttribute("transform",`rotate(${g*s})`)});const[o,r]=e.f,a=o/t.weight*150,[l,c]=[r*Math.sin(e.x[0][0])*n,Mo-(t.wheel_radius+r*Math.cos(e.x[0][0]))*n],h=Math.sign(o)*7;this.arrow.setAttribute("d",Math.abs(o)>.005?`M${l-a-h} ${c}H${l}m${-h} -5L${l} ${c}l${-h} 5`:"")}draw(){}picture(){return Promise.resolve(new Blob([new XMLSerializer().serializeToString(this.element)],{type:"image/svg+xml"}))}turn(){}zoom(){}grasp(){const e=(this.sides[0]?.body.firstElementChild??this.element).getBoundingClientRect(),t=this.element.getBoundingClientRect();return{x:e.x-t.x+e.width/2,y:e.y-t.y+e.height*.4}}down(e){const t=this.sides[0];if(!this.look||!t?.root.contains(e.target))return;this.element.setPointerCapture(e.pointerId);const n=this.element.getBoundingClientRect().height/200,s=this.element.getBoundingClientRect().y+(Mo-this.look.wheel_radius*this.scale(this.look))*n;this.grip={x:e.clientX,height:Math.max(0,(s-e.clientY)/n/this.scale(this.look))},this.push({force:0,height:this.grip.height})}moved(e){if(!this.grip||!this.look)return;const t=this.scale(this.look)*this.element.getBoundingClientRect().height/200;this.push({force:Um((e.clientX-this.grip.x)/t,this.look),height:this.grip.height})}up(){this.grip&&(this.grip=null,this.push({force:0,height:0}))}}function $n(i,e={}){const t=document.createElementNS(PD,i);for(const[n,s]of Object.entries(e))s!==""&&t.setAttribute(n,String(s));return t}const If=.25,Uf=1.5,DD=.12,ID=.15;class UD{held=new Set;last="";asked=0;padded=!1;constructor(){window.addEventListener("keydown",e=>this.down(e)),window.addEventListener("keyup",e=>this.up(e)),window.addEventListener("blur",()=>this.release())}down(e){const t=e.target;e.repeat||e.ctrlKey||e.metaKey||e.altKey||/^(INPUT|SELECT|TEXTAREA)$/.test(t.tagName)||t.getAttribute("role")==="tab"||t.closest("dialog")||/^(Arrow(Up|Down|Left|Right)|f|b)$/.test(e.key)&&(e.preventDefault(),this.held.add(e.key),this.push(),this.steer(...this.keys()))}up(e){this.held.delete(e.key)&&(this.push(),this.steer(...this.keys()))}release(){this.held.size&&(this.held.clear(),this.push(),this.steer(0,0))}keys(){const e=t=>this.held.has(t)?1:0;return[If*(e("ArrowUp")-e("ArrowDown")),Uf*(e("ArrowLeft")-e("ArrowRight"))]}pushing=!1;push(){const e=(this.held.has("b")?1:0)-(this.held.has("f")?1:0);if(!e&&!this.pushing)return;this.pushing=e!==0;const t=N.changed?.look;N.push({kind:"Drag",force:e*DD*(t?.weight??6),height:t?.com_height??.07})}steer(e,t){const n=`${e.toFixed(2)} ${t.toFixed(2)}`;n!==this.last&&(this.last=n,N.send({kind:"Steer",speed:e,rate:t}))}tick(e){if(e-this.asked<60)return;this.asked=e;const t=navigator.getGamepads?.().find(s=>s?.connected);if(this.held.size||!t&&!this.padded)return;this.padded=!!t;const n=s=>{const o=t?.axes[s]??0;return Math.abs(o)<ID?0:-o};this.steer(If*n(1),Uf*n(0))}}const kD=[.2,3/8,5/9,2/3],FD=(i,e)=>t=>{const n=4*i+t-4,s="*-04-39?2$%%$%%'$%''%'''%')(%'))%(++'(++'(+.'+-.',/3',33)-/5)-43).36)058*18<+37<+4:<,4:E,5<A-7>C/8@F/:EH/<EK0=FM1?IP2@KS3BNV4DPY5FS\\6HV_6IXb7K[e8N^i9Pam;Rdp<Tgt".charCodeAt(n)-35,o=n>8?s:1,r=e/o|0,a=e%o,l=o-a,c=n>8?r*kD[t]+(i>5)&-2:s,h=r-c;return{t:l*h+a*h+a,o:[[l,h],[a,h+1]],i:c}},kf={M:1},Xs=i=>new Uint8Array(i),gr=i=>{const e=new Error(`lean-qr error ${i}`);throw e.code=i,e},pa=i=>"0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZ $%*+-./:".indexOf(i),nh=i=>i.charCodeAt(0),km=(...i)=>(e,t)=>i.forEach(n=>n(e,t)),Fm=i=>e=>{e.eci!==i&&(e.push(7,4),i<128?e.push(i,8):i<16384?e.push(32768|i,16):e.push(12582912|i,24),e.eci=i)},Wh=i=>(e,t)=>{e.push(4,4),e.push(i.length,8+8*(t>9)),i.forEach(n=>e.push(n,8))},Yo=(i,e,t,n,s=(r,a)=>t(r.length,a),o=n?r=>km(Fm(n),i(r)):i)=>(o.test=e,o.l=t,o.est=s,o.eci=n&&[n],o),Om=Yo(i=>(e,t)=>{e.push(1,4),e.push(i.length,10+2*(t>26)+2*(t>9));let n=0;for(;n<i.length-2;n+=3)e.push(+i.slice(n,n+3),10);n<i.length-1?e.push(+i.slice(n),7):n<i.length&&e.push(+i[n],4)},i=>/[0-9]/.test(i),(i,e)=>14+2*(e>26)+2*(e>9)+10*i/3),Bm=Yo(i=>(e,t)=>{e.push(2,4),e.push(i.length,9+2*(t>26)+2*(t>9));let n=0;for(;n<i.length-1;n+=2)e.push(45*pa(i[n])+pa(i[n+1]),11);n<i.length&&e.push(pa(i[n]),6)},i=>pa(i)>=0,(i,e)=>13+2*(e>26)+2*(e>9)+5.5*i),Vo=Yo(i=>Wh([...i].map(nh)),i=>nh(i)<128,(i,e)=>12+8*(e>9)+8*i);Vo._=!0,Vo.u=!0;const $h=Yo(Vo,i=>nh(i)<256,Vo.l,3);$h._=!0;const Ff=new TextEncoder,qh=Yo(i=>Wh(Ff.encode(i)),()=>1,0,26,(i,e)=>12+8*(e>9)+8*Ff.encode(i).length);qh._=!0;let ih=()=>{const i=new Map,e=new TextDecoder("sjis"),t=Xs(2);for(let n=0;n<7973;++n)t[0]=n/192+129+64*(n>5951),t[1]=n%192+64,i.set(e.decode(t),n);return i.delete("�"),ih=()=>i,i};const Xh=Yo(i=>(e,t)=>{e.push(8,4),e.push(i.length,8+2*(t>26)+2*(t>9));for(const n of i)e.push(ih().get(n),13)},i=>ih().has(i),(i,e)=>12+2*(e>26)+2*(e>9)+13*i);Xh._=!0;const zm=[Om,Bm,Vo,$h,Xh,qh],OD={auto:(i,{modes:e=zm}={})=>(t,n)=>{const s=e.map((h,u)=>{const d=new Map,m=(g,_)=>(d.has(g)||d.set(g,_(g,n)),d.get(g));return{m:h,h:1<<u,C:h.est("",n),S:h.l?(g,_)=>m(_-g,h.l):(g,_)=>m(i.slice(g,_),h.est)}});let o=[{v:0}],r=0,a=0,l=-1;for(const h of[...i,""]){let u=0;if(h)for(const d of s)d.m.test(h)&&(u|=d.h);if(!h||u!==l){if(l!==-1){const d=new Set(o.map(g=>g.D)),m=[];for(const{m:g,C:_,S:p,h:f}of s)if(l&f){const M=p(r,a);for(const S of g.eci??d)if(!g.u||!S){let x;for(const F of o)if(F.D===S||g.eci){const P=F.m===g&&F.D===S,A=P?F.V:F,I=g._&&P?F.v+M-_:A.v+12*(A.D!==S)+(P?p(P?F.$:r,a):M);(!x||I<x.v)&&(x={$:P?F.$:r,V:A,m:g,D:S,A:a,v:I})}x&&m.push(x)}}o=m}l=u,r=a}a+=h.length}o.length||gr(5);const c=[];for(let h=o.reduce((u,d)=>d.v<u.v?d:u);h.m;h=h.V)c.push(h.m(i.slice(h.$,h.A)));c.reverse().forEach(h=>h(t,n))},multi:km,eci:Fm,bytes:Wh,numeric:Om,alphaNumeric:Bm,ascii:Vo,iso8859_1:$h,shift_jis:Xh,utf8:qh},BD=()=>({F:Xs(2956),I:0,push(i,e){for(let t=e,n=8-(7&this.I);t>0;t-=n,n=8)this.F[this.I>>3]|=i<<n>>t,this.I+=t<n?t:n}}),Ql=(i,e=i*i,t=Xs(e))=>({size:i,K:t,get:(n,s)=>n>=0&&n<i&&!!(1&t[s*i+n]),toString({on:n="##",off:s="  ",lf:o=`
`,pad:r=4,padX:a=r,padY:l=r}={}){let c="";for(let h=-l;h<i+l;++h){for(let u=-a;u<i+a;++u)c+=this.get(u,h)?n:s;c+=o}return c},toImageData(n,{on:s=[0,0,0],off:o=[0,0,0,0],pad:r=4,padX:a=r,padY:l=r}={}){const c=i+2*a,h=i+2*l,u=n.createImageData(c,h),d=new Uint32Array(u.data.buffer);u.data.set([...s,255]);const m=d[0];u.data.set([...o,255]);const g=d[0];for(let _=0;_<h;++_)for(let p=0;p<c;++p)d[_*c+p]=this.get(p-a,_-l)?m:g;return u},toCanvas(n,s){const o=n.getContext("2d"),r=this.toImageData(o,s);n.width=r.width,n.height=r.height,o.putImageData(r,0,0)},toDataURL({type:n="image/png",scale:s=1,...o}={}){const r=document.createElement("canvas"),a=r.getContext("2d"),l=this.toImageData(a,o);return r.width=l.width*s,r.height=l.height*s,a.putImageData(l,0,0),a.imageSmoothingEnabled=!1,a.globalCompositeOperation="copy",a.drawImage(r,0,0,l.width,l.height,0,0,r.width,r.height),r.toDataURL(n,1)}}),ma=[(i,e)=>1&(i^e),(i,e)=>1&e,i=>i%3,(i,e)=>(i+e)%3,(i,e)=>1&(i/3^e>>1),(i,e)=>(i&e&1)+i*e%3,(i,e)=>(i&e)+i*e%3&1,(i,e)=>(i^e)+i*e%3&1],Oa=Xs(511);for(let i=0,e=1;i<255;e=2*e^285*(e>127))Oa[Oa[e+255]=i++]=e;const Hm=i=>Oa[i%255],Vm=i=>Oa[i+255],zD=(i,e)=>{const t=Xs(i.length+e.length-1);for(let n=0;n<i.length;++n)for(let s=0;s<e.length;++s)t[n+s]^=Hm(i[n]+e[s]);return t.map(Vm)},HD=(i,e)=>{const t=Xs(i.length+e.length-1);t.set(i,0);for(let n=0;n<i.length;++n)if(t[n]){const s=Vm(t[n]);for(let o=0;o<e.length;++o)t[n+o]^=Hm(e[o]+s)}return t.slice(i.length)},sh=[[0],[0,0]];for(let i=1;i<30;++i)sh.push(zD(sh[i],[0,i]));const VD=(i,e)=>{const t=[[],[]];let n=0,s=0;for(const[r,a]of e.o)for(let l=0;l<r;++l,n+=a){const c=i.slice(n,n+a);t[0].push(c),t[1].push(HD(c,sh[e.i])),s+=a+e.i}const o=Xs(s);s=0;for(const r of t)for(let a=0,l=-1;l<s;++a){l=s;for(const c of r)a<c.length&&(o[s++]=c[a])}return o},Gm=(i,e,t)=>{let n=i<<=t;for(let s=134217728;s>>=1;)n&s&&(n^=e*(s>>t));return n|i},GD=({size:i,K:e},t)=>{const n=(r,a,l,c)=>{for(;l-- >0;r+=i)e.fill(c,r,r+a)},s=(r,a,l)=>{for(let c=0;c++<3;l-=2)n(a*i+r-(l>>1)*(i+1),l,l,2|c)},o=2*((i-13)/(1+(t/7|0))/2+.75|0);if(t>1)for(let r=i-7;r>8;r-=o){for(let a=r;a>8;a-=o)s(r,a,5);r<i-7&&s(r,6,5)}if(t>6)for(let r=Gm(t,7973,12),a=1;a<7;++a)for(let l=12;l-- >9;r>>=1)e[a*i-l]=2|1&r;n(7,2,9,2),n(i-8,8,9,2);for(let r=0;r<i;++r)e[6*i+r]=3^1&r;s(3,3,7),s(i-4,3,7);for(let r=0;r<i;++r)for(let a=r;a<i;++a)e[a*i+r]=e[r*i+a];e[(i-8)*i+8]=3},WD=({size:i,K:e})=>{const t=[];for(let n=i-2,s=i,o=-1;n>=0;n-=2){for(n===5&&(n=4);s+=o,s!==-1&&s!==i;){const r=s*i+n;e[r+1]||t.push(r+1),e[r]||t.push(r)}o*=-1}return t},$D=({K:i},e,t)=>e.forEach((n,s)=>i[n]=t[s>>3]>>(7&~s)&1),qD=({size:i,K:e},t,n,s)=>{for(let r=0;r<i;++r)for(let a=0;a<i;++a){const l=r*i+a;e[l]^=!(t(a,r)||2&e[l])}let o=21522^Gm((1^s)<<3|n,1335,10);for(let r=0;r++<8;o>>=1)e[(r-(r<7))*i+8]=1&o,e[9*i-r]=1&o;for(let r=8;--r,o;o>>=1)e[8*i+r-(r<7)]=1&o,e[(i-r)*i+8]=1&o},XD=({size:i,K:e},t=0,n=0)=>{for(let s=0;s<i;++s){for(let o=0;o<2;++o)for(let r,a=0,l=0,c=2;a<i;++a){const h=1&e[o?s*i+a:a*i+s];n+=h,l=(l>>1|2098176)&(3047517^h-1),2049&l&&(t+=40),h^c&&(r=0),c=h,t+=++r===5?3:r>5}if(s)for(let o=i+s,r=5*e[s-1]^e[s];o<i*i;o+=i){const a=5*e[o-1]^e[o];t+=3*!(1&(r|a)|4&(r^a)),r=a}}return t+10*(10*Math.abs(n/(i*i)-1)|0)},Of=[],oh=(i=gr(1),{minCorrectionLevel:e=0,maxCorrectionLevel:t=3,minVersion:n=1,maxVersion:s=40,mask:o,trailer:r=60433,...a}={})=>{t<e&&gr(3),s<n&&gr(2),typeof i=="string"&&(i=OD.auto(i,a));for(let l=n,c=0;l<=s;++l){let h=Of[l];h||(Of[l]=h=Ql(4*l+17),GD(h,l),h.p=WD(h));const u=FD(l,h.p.length>>3);if(8*u(e).t<c)continue;const d=BD();i(d,l),c=d.I;for(let m=t;m>=e;--m){const g=u(m);if(8*g.t<c)continue;for(d.I=c+11&-8;d.I<8*g.t;)d.push(r,16);const _=Ql(h.size,h.K);return $D(_,h.p,VD(d.F,g)),(ma[o]?[ma[o]]:ma).map((p,f)=>{const M=Ql(_.size,_.K);return qD(M,p,o??f,m),M.s=ma[o]?0:XD(M),M}).reduce((p,f)=>f.s<p.s?f:p)}}gr(4)};oh.with=(...i)=>(e,t)=>oh(e,{modes:[...zm,...i],...t});const ec="http://www.w3.org/2000/svg",cr=4;function jD(i,e){const t=oh(i,{minCorrectionLevel:kf.M,maxCorrectionLevel:kf.M}),n=document.createElementNS(ec,"svg"),s=t.size+2*cr;n.setAttribute("viewBox",`${-cr} ${-cr} ${s} ${s}`),n.setAttribute("class","qr"),n.setAttribute("role","img"),n.setAttribute("aria-label",e);const o=document.createElementNS(ec,"rect");for(const[l,c]of Object.entries({x:-cr,y:-cr,width:s,height:s,fill:"#ffffff"}))o.setAttribute(l,String(c));const r=document.createElementNS(ec,"path");let a="";for(let l=0;l<t.size;l+=1)for(let c=0;c<t.size;c+=1)t.get(c,l)&&(a+=`M${c} ${l}h1v1h-1z`);return r.setAttribute("d",a),r.setAttribute("fill","#000000"),r.setAttribute("shape-rendering","crispEdges"),n.append(o,r),n}const Bf="http://www.w3.org/2000/svg";class YD{root=k("div",{className:"panel-body"});wall=k("div",{className:"wall"});scores=k("div",{className:"table"});build(){const e=k("div",{className:"column wide"});N.role==="teacher"&&e.append(k("div",{className:"row"},lt(U("broadcast"),()=>N.send({kind:"Broadcast",setup:N.setup}),{className:"main","data-key":"broadcast"}),lt(U("results"),()=>JD(ZD()),{"data-key":"results"})),KD(),this.wall),e.append(this.scores),Qe(this.root,e),this.update()}update(){const e=N.board?.students??[];Qe(this.wall,...e.map(QD));const t=k("thead",{},k("tr",{},...["",U("name"),U("bestPush"),U("effort"),U("family")].map(s=>k("th",{scope:"col"},s)))),n=e.map((s,o)=>k("tr",{className:s.here?"":"away"},k("td",{},String(o+1)),k("td",{},s.name),k("td",{},ss(s.best,3)),k("td",{},ss(s.effort,0)),k("td",{},wn(s.controller).split(":")[0])));Qe(this.scores,k("table",{className:"board","aria-label":U("board")},t,k("tbody",{},...n)))}}function KD(){const i=new URL(`#token=${N.invite}`,location.href.split("#")[0]).href;return k("figure",{className:"invite"},jD(i,U("invite")),k("figcaption",{},k("b",{},U("invite")),k("code",{},i)))}function ZD(){const i=t=>`"${t.replace(/^[=+\-@\t]/,"'$&").replaceAll('"','""')}"`;return["place,name,best_push_Ns,effort_u2s,controller,here",...(N.board?.students??[]).map((t,n)=>[n+1,i(t.name),t.best.toFixed(4),t.effort.toFixed(1),i(t.controller),t.here].join(",")),""].join(`\r
`)}function JD(i){const e=URL.createObjectURL(new Blob(["\uFEFF",i],{type:"text/csv"}));k("a",{href:e,download:"results.csv"}).click(),window.setTimeout(()=>URL.revokeObjectURL(e),1e4)}function QD(i){const e=document.createElementNS(Bf,"svg");e.setAttribute("viewBox","-30 -48 60 60"),e.setAttribute("aria-hidden","true");const t=(s,o)=>{const r=document.createElementNS(Bf,s);for(const[a,l]of Object.entries(o))r.setAttribute(a,l);e.append(r)},n=(i.pitch*180/Math.PI).toFixed(1);return t("rect",{x:"-6",y:"-40",width:"12",height:"38",rx:"3",class:"stick",transform:`rotate(${n})`}),t("circle",{r:"8",cx:"0",cy:"0",class:"wheel"}),t("line",{x1:"-30",x2:"30",y1:"8.5",y2:"8.5",class:"ground"}),k("figure",{className:`tile${i.fallen?" down":""}${i.here?"":" away"}`},e,k("figcaption",{},i.name))}const Cs=["twin","nonlinear","linear"],eI=[{setup:{},lean:0},{setup:{controller:"off",bodies:Cs},lean:Xa,speed:.1},{setup:{controller:"off",kit:"ideal",bodies:["nonlinear","linear"]},lean:.03,speed:.1},{setup:{controller:"lqr",bodies:Cs},lean:.1},{setup:{controller:"lqg",bodies:Cs},lean:0,strike:"front"},{setup:{controller:"lqg",bodies:Cs},lean:0,strike:"back"},{setup:{controller:"lqg",bodies:Cs},lean:0,strike:"front",live:!0},{setup:{controller:"lqr",bodies:Cs,payload:.2,payload_height:.3},lean:0},{setup:{controller:"robust",bodies:Cs,payload:.2,payload_height:.3},lean:0,live:!0}],hr=eI.map((i,e)=>({scene:i,i:e})).filter(({scene:i})=>!(Jt&&i.live));class tI{constructor(e){this.run=e}root=k("div",{className:"panel-body tour"});at=0;before=null;build(){const{here:e,...t}=bh().tour[hr[this.at].i],n={...t,...Jt&&e},s=(o,r)=>k("div",{className:"hint-part"},k("h4",{},o),k("p",{},r));Qe(this.root,k("div",{className:"column wide"},k("p",{className:"note"},U("tourStep",{n:this.at+1,all:hr.length})),k("h3",{},n.title),k("div",{className:"hints"},s(U("tourDo"),n.do),s(U("tourWatch"),n.watch),s(U("tourAsk"),n.ask)),k("div",{className:"row"},lt(U("previous"),()=>this.move(-1,"previous"),{disabled:this.at===0,"data-key":"tour-previous"}),this.at||this.before?lt(U("tourSet"),()=>this.set(),{className:this.at?"main":"","data-key":"tour-set"}):null,lt(U("next"),()=>this.move(1,"next"),{className:this.at?"":"main",disabled:this.at===hr.length-1,"data-key":"tour-next"})),this.before?lt(U("tourBack"),()=>this.back(),{className:"quiet","data-key":"tour-back"}):null))}move(e,t="set"){this.at=Math.min(Math.max(this.at+e,0),hr.length-1),this.build();const n=o=>this.root.querySelector(`[data-key=tour-${o}]:enabled`);(n(t)??n("set")??n("next"))?.focus({preventScroll:Sr.matches});const s=this.root.parentElement;s&&(s.scrollTop=0),Sr.matches&&this.upward(s?.parentElement?.querySelector(".tabs"))}upward(e){if(!e)return;const t=Math.max(...[e,document.documentElement].map((n,s)=>parseFloat(getComputedStyle(n)[s?"scrollPaddingTop":"scrollMarginTop"])||0));this.root.getBoundingClientRect().top<t+e.clientHeight&&(t?e:e.parentElement)?.scrollIntoView()}back(){this.before&&N.change(this.before),this.before=null,this.run(1),N.send({kind:"StandUp",pitch:0}),this.build()}set(){const{setup:e,lean:t,speed:n,strike:s}=hr[this.at].scene;this.before||(this.before=N.setup,this.build(),this.root.querySelector("[data-key=tour-set]")?.focus()),N.anew(()=>{this.run(n??1),N.change({...Vi,...e}),N.send({kind:"StandUp",pitch:t})}),s&&window.setTimeout(()=>N.send({kind:"Strike",what:s,size:s==="front"?.1:-.12}),1e3)}}const zf=["Tour","Controller","Robot","Kit","See","Identify","Keep","Class","Python"],Hf=["Tour","Controller","Robot","See","Keep","Python"],nI=.19,iI=10,sI=400;function oI(){const i=document.createElement("canvas").getContext("webgl2"),e=i?.getExtension("WEBGL_debug_renderer_info"),t=i?.getParameter(e?.UNMASKED_RENDERER_WEBGL??i.RENDERER);return i?.getExtension("WEBGL_lose_context")?.loseContext(),{able:i!==null,quick:!/swiftshader|llvmpipe|software|basic render/i.test(t)}}class rI{constructor(e){this.app=e,this.theme(os.getItem("theme")??"");const t=new URLSearchParams(location.hash.slice(1)).get("lang")??"";Qu(Object.hasOwn(Mr,t)?t:os.getItem("language")??(navigator.language.startsWith("es")?"es":"en")),N.listen(n=>this.hear(n)),N.say=(n,s="info")=>this.toast(n,s),N.corrected=()=>this.toasts.querySelectorAll(".toast.error").forEach(n=>n.remove()),this.scrub.addEventListener("input",()=>N.send({kind:"Scrub",back:Number(this.scrub.max)-Number(this.scrub.value)})),this.equip(),this.measure("--toasts",this.toasts),this.measure("--fell",this.fell,8),window.addEventListener("keydown",n=>this.key(n)),window.addEventListener("hashchange",()=>N.recorded||this.link()),this.begin()}deeper=null;room=this.furnish();charts=new XT(()=>iI*this.speed);see=new tR;controller=new hR;local=null;robot=Jt?new BA(()=>this.local):new uR;python=new zA;kit=new dR;identify=new pR;keep=new mR(()=>this.picture());tour=new tI(e=>(this.greeted(),this.run(e)));classes=new YD;newcomer=!os.getItem("toured")&&!Pa(location.hash);tab=this.newcomer?"Tour":"Controller";knock=.05;speed=1;scrub=k("input",{type:"range",min:"-60",max:"0",step:"0.02",value:"0",className:"scrub","data-key":"scrub"});pauseButton=k("button",{type:"button","data-key":"pause"});status=k("span",{className:"status",role:"status"});light=k("button",{type:"button",className:"headlight",onclick:()=>this.open("Controller")});force=k("div",{className:"force","aria-hidden":"true"});fell=k("div",{className:"fell",role:"status"});toasts=k("div",{className:"toasts",role:"log","aria-live":"polite"});spoken=k("p",{className:"hidden","aria-live":"off"});tabs=k("div",{className:"tabs",role:"tablist"});panel=k("div",{className:"panel",role:"tabpanel",tabIndex:-1,id:"panel"});clock=k("span",{className:"clock"});state="connecting";drawn=0;down=null;lost=null;best={};most=k("span",{className:"most"});telling=0;begun=!1;timing=!1;drawnFirst=!1;seen=0;plotted=0;said=0;shape="";steering=new UD;pinned=null;begin(){const e=Ad.inPage(),t=LT(location.hash)||(ki.getItem("token")??"");t&&ki.setItem("token",t),location.hash.includes("token=")&&history.replaceState(null,"",location.pathname),this.build(),Jt?(document.body.classList.add("exported"),this.local=new DA(Jt),this.link(),this.says("connected")):e?(this.says("replaying"),new Ad(e),document.body.classList.add("replay")):t&&!ki.getItem("name")&&t.length<12?this.join(t):this.connect(t,ki.getItem("name")??""),requestAnimationFrame(n=>this.frame(n))}connect(e,t){new VA({token:e,name:t},(n,s)=>this.says(n,s))}join(e){const t=k("input",{type:"text",id:"name",maxLength:40,required:!0,autocomplete:"name"}),n=k("dialog",{className:"join","aria-label":U("joinTitle")},k("form",{method:"dialog",onsubmit:s=>{s.preventDefault(),t.value.trim()&&(ki.setItem("name",t.value.trim()),n.remove(),this.connect(e,t.value.trim()))}},k("h2",{},U("joinTitle")),k("label",{for:"name"},U("yourName")),t,k("button",{className:"main"},U("enter"))));this.app.append(n),n.showModal()}build(){const e=Object.entries(Mr).map(([s,o])=>[s,o.language]),t=k("header",{},k("a",{className:"skip",href:"#panel",onclick:()=>this.panel.focus()},U("skip")),k("h1",{},k("span",{className:"mark","aria-hidden":"true"}),U("title")),k("p",{className:"what"},U("what")),this.light,k("span",{className:"grow"}),this.clock,this.status,Jt?HA(s=>this.toast(s,"info")):null,ds("",e,Rp(),s=>this.speak(s),"language"),lt("◐",()=>this.theme(document.documentElement.dataset.theme==="dark"?"light":"dark"),{"aria-label":U("theme"),title:U("theme"),"data-key":"theme"}),lt("?",()=>this.help(),{"aria-label":U("help"),title:U("help"),"data-key":"help"}));t.querySelector("select")?.setAttribute("aria-label","Language / Idioma");const n=k("section",{className:"scene","aria-label":U("scene")},this.room.element,this.force,this.fell,k("p",{className:"hint"},k("span",{},U("hint")),this.invitation()),this.charts.slot,this.pushes(),this.transport());this.pin(n),Qe(this.app,t,k("main",{},n,this.panels(),this.charts.root),this.toasts,this.spoken),this.lamp(),!N.snapshot&&!N.recorded&&this.tell(oi(()=>U("starting"))),N.changed&&this.rebuild()}pin(e){const n={rootMargin:`1000000px 0px ${nI*innerHeight+8*parseFloat(getComputedStyle(document.documentElement).fontSize)-innerHeight}px`},s=new IntersectionObserver(o=>e.classList.toggle("pinned",o.at(-1)?.isIntersecting??!1),n);this.pinned?.disconnect(),this.pinned=s,s.observe(this.tabs)}furnish(){const e=Sh(33,o=>N.push({kind:"Drag",force:o.force,height:o.height})),t=()=>new CD(k("canvas",{className:"room",tabIndex:0,role:"img"}),e),{able:n,quick:s}=oI();return n&&(s||!Jt)?t():(this.deeper=n?t:null,new ND(e))}measure(e,t,n=0){const s=()=>document.documentElement.style.setProperty(e,`${t.childElementCount&&t.offsetHeight+n}px`);new ResizeObserver(s).observe(t)}equip(){this.room.element.setAttribute("aria-label",U("scene")),this.room.element.addEventListener("keydown",e=>this.look(e))}deepen(){const[e,t]=[N.changed,this.room.element];!this.deeper||!e||N.snapshot?.f[0]||(this.room=this.deeper(),this.deeper=null,this.equip(),this.room.furnish(e.look,e.bodies),t.replaceWith(this.room.element),N.snapshot&&this.room.move(N.snapshot),this.room.draw(0))}link(){Pa(location.hash)&&this.speed!==1&&this.run(1),FA()}run(e,t=!1){this.speed=e;const n=this.app.querySelector("[data-key=speed]");n&&(n.value=String(e)),N.send({kind:"Play",paused:t,speed:e})}transport(){this.pauseButton.onclick=()=>this.pause();const e=[["0.05","× 1/20"],["0.1","× 1/10"],["0.25","× 1/4"],["0.5","× 1/2"],["1","× 1"]],t=ds(U("speed"),e,String(this.speed),r=>this.run(Number(r),N.snapshot?.paused),"speed");t.querySelector("select")?.setAttribute("aria-label",U("speed"));const n=lt(U("step"),()=>N.send({kind:"Step",periods:1}),{title:U("stepTip"),"data-key":"step"}),s=U(N.recorded?"timeLine":"back");this.scrub.setAttribute("aria-label",s),N.recorded&&([this.scrub.min,this.scrub.max]=["0",String(N.recorded)]);const o=lt(U("standUp"),()=>this.stand(),{"data-key":"stand"});return k("div",{className:"transport"},this.pauseButton,n,o,t,k("label",{className:"scrubbing"},k("span",{},s),this.scrub))}pushes(){const e=(s,o)=>()=>N.push({kind:"Strike",what:s,size:o}),t=()=>N.changed?.look.weight??6,n=Kn(U("size"),{low:.01,high:.5,step:.01,show:s=>`${ss(s,2)} N s`,key:"knock"},s=>this.knock=s);return n.set(this.knock),n.root.title=U("sizeTip"),n.root.insertBefore(this.most,n.root.lastChild),this.champion(),k("div",{className:"pushes",role:"group","aria-label":U("pushes")},lt(U("impulse"),()=>e("impulse",this.knock)(),{title:U("impulseTip"),className:"main","data-key":"impulse"}),n.root,lt(U("front"),e("front",.1),{title:U("frontTip"),"data-key":"front"}),lt(U("backPush"),e("back",-.12),{title:U("backTip"),"data-key":"back"}),lt(U("pullLeft"),()=>e("pull_left",.25*t())(),{title:U("pullTip"),"data-key":"pull_left"}),lt(U("pullRight"),()=>e("pull_right",.25*t())(),{title:U("pullTip"),"data-key":"pull_right"}),lt(U("tilt"),()=>N.send({kind:"StandUp",pitch:.1}),{title:U("tiltTip"),"data-key":"tilt"}))}panels(){const e=Jt?Hf:zf.filter(n=>n!=="Python"&&(n!=="Class"||N.role!=="alone")),t={Controller:U("tabController"),Robot:U("tabRobot"),Kit:U("tabKit"),See:U("tabSee"),Identify:U("tabIdentify"),Keep:U("tabKeep"),Tour:U("tabTour"),Class:U("tabClass"),Python:U("tabPython")};return this.tabs.setAttribute("aria-label",U("tabs")),Qe(this.tabs,...e.map(n=>lt(t[n],()=>this.bring(n),{role:"tab",id:`tab-${n}`,"aria-selected":String(n===this.tab),"aria-controls":"panel",tabIndex:n===this.tab?0:-1,"data-key":`tab-${n}`,onkeydown:s=>this.along(s,e,n)}))),k("section",{className:"below"},this.tabs,this.panel)}along(e,t,n){const s={ArrowRight:1,ArrowLeft:-1}[e.key];if(!s)return;e.preventDefault(),e.stopPropagation();const o=t[(t.indexOf(n)+s+t.length)%t.length];this.open(o),document.getElementById(`tab-${o}`)?.focus()}invitation(){return this.newcomer?lt(U("newHere"),()=>this.bring("Tour"),{"data-key":"invitation"}):null}bring(e){this.open(e),Sr.matches&&this.tabs.scrollIntoView(),document.getElementById(`tab-${e}`)?.scrollIntoView({block:"nearest",inline:"center"})}greeted(){this.newcomer=!1,os.setItem("toured","yes"),this.app.querySelector("[data-key=invitation]")?.remove()}open(e){this.tab=e,this.greeted();for(const t of this.tabs.querySelectorAll("[role=tab]")){const n=t.id===`tab-${e}`;t.setAttribute("aria-selected",String(n)),t.tabIndex=n?0:-1}this.panel.setAttribute("aria-labelledby",`tab-${e}`),this.fill()}fill(){if(!N.catalogue||!N.changed)return;const e={Controller:this.controller,Robot:this.robot,Kit:this.kit,See:this.see,Identify:this.identify,Keep:this.keep,Tour:this.tour,Class:this.classes,Python:this.python}[this.tab];xr(()=>{Jt&&e===this.keep?this.keep.buildExported():e.build(),Qe(this.panel,e.root)})}rebuild(){this.shape="",this.follow(),this.fill(),this.lamp()}follow(){const e=N.changed;if(!e)return;const t=JSON.stringify([e.bodies,e.look]);t!==this.shape&&(this.shape=t,this.room.furnish(e.look,e.bodies),this.charts.build())}hear(e){switch(e.kind){case"Welcome":this.timing=!Jt&&!N.recorded,xr(()=>this.build());break;case"Catalogue":this.fill();break;case"Changed":{const t=!this.panel.firstChild;this.follow(),!this.begun&&!Jt&&this.link(),this.begun=!0,t?this.fill():this.update(),this.lamp(),this.champion();break}case"Analysed":case"Light":this.lamp(),this.update();break;case"Equations":this.tab==="See"&&this.see.show();break;case"Snapshot":this.transported();break;case"Progress":this.identify.progress(e.job,e.fraction),e.job==="certify"&&this.controller.certifying(e.fraction);break;case"JobResult":this.identify.found(),e===N.certified&&this.controller.certify(),(e!==N.certified||this.tab!=="Controller")&&this.toast(()=>`${U(e.job)}: ${Wt(e.title)}`,e.ok?"info":e.job==="certify"?"error":"warn"),Is&&this.tab==="Identify"&&xr(()=>this.identify.build());break;case"Made":this.keep.made(e.name,e.url.startsWith("blob:")?e.url:N.files+e.url),this.toast(()=>U("made",{name:e.name}),"info");break;case"Notice":e.key==="lies"?this.lie(()=>U("lies")):this.toast(()=>e.key?wn(e.key):Lp(e.text),e.level);break;case"Recovered":this.recovered(e);break;case"Board":this.tab==="Class"&&this.classes.update();break}}update(){this.tab==="See"&&this.see.show(),{Controller:this.controller,Robot:this.robot,Kit:this.kit,Python:this.python}[this.tab]?.update()}lamp(){const e=Kp();if(this.app.classList.toggle("loose",N.falls||(N.changed?.busy??!1)),N.recorded&&(N.lit?.light??"none")==="none")return Qe(this.light);const t=Zp()[1]?.textContent??"";this.light.title=`${t[0].toUpperCase()}${t.slice(1)}. ${U("lightNote")}`;const n=N.setup.controller==="off"?t:t.split(",")[0]+Yp().split(",").slice(0,2).join();Qe(this.light,k("span",{className:`lamp ${e}`,"aria-hidden":"true"}),k("span",{},`${U("certificate")}:`),k("span",{},n))}recovered({impulse:e,fell:t,single:n}){const s=this.driven(),o=Math.max(this.best[s]??0,n&&!t?e:0);o&&(this.best[s]=o),this.champion();const r=()=>({impulse:_t(e),best:_t(o)});if(t&&(this.lost=()=>U(n?"lostPush":"lostPushes",r())),this.down)return this.lie();t||(this.tell(oi(()=>U(n?e<o?"recovered":"recoveredMost":"recoveredSeveral",r()))),this.telling=window.setTimeout(()=>this.tell(),6e3))}driven(){return`${N.setup.robot} ${N.setup.controller}`}champion(){const e=this.best[this.driven()];this.most.textContent=e?U("best",{best:_t(e)}):"",this.most.title=U("bestTip")}tell(...e){window.clearTimeout(this.telling),Qe(this.fell,...e)}lie(e=this.lost??(()=>U("fallen"))){const t=k("button",{type:"button",className:"main",onclick:()=>this.stand()},oi(()=>U("standUp")));this.tell(oi(e),N.recorded?null:t)}transported(){const e=N.snapshot;if(!e)return;this.timing&&N.send({kind:"Play",paused:e.paused,speed:this.speed}),this.timing=!1;const t=e.paused?U("play"):U("pause");this.pauseButton.textContent!==t&&(this.pauseButton.textContent=t),N.recorded?this.timed(e.t):document.activeElement!==this.scrub&&(this.scrub.value=String(-e.back)),this.clock.textContent=`${ss(e.t,1)} ${N.recorded?`/ ${ss(N.recorded,1)} `:""}s`;const n=!!e.x[0][8];n!==this.down&&(n||(this.lost=null),this.down=n,n?this.lie():this.tell(),this.app.querySelector("[data-key=impulse]")?.classList.toggle("main",!n));const s=e.f[0],o=e.f[2]?`${U("slope")}: ${yh(e.f[2])}`:"";N.traces.marks.some(({what:r})=>r!=="stood")&&this.app.classList.add("pushed"),this.force.textContent=Math.abs(s)>.005?U("newtons",{force:ss(s,2)}):o,this.force.classList.toggle("slope",!(Math.abs(s)>.005))}timed(e){this.scrub.matches(":active")||(this.scrub.value=String(e)),this.scrub.setAttribute("aria-valuetext",`${ss(e,1)} s`)}seek(e){const[t,n]=[N.snapshot,N.recorded||60],s=(N.recorded?N.recorded-(t?.t??0):t?.back??0)-e;N.send({kind:"Scrub",back:Math.max(0,Math.min(n,s))})}stand(){N.send({kind:"StandUp",pitch:N.falls?Xa:0}),N.send({kind:"Play",paused:!1,speed:this.speed})}pause(){N.send({kind:"Play",paused:!N.snapshot?.paused,speed:this.speed})}says(e,t=""){this.state=e;const n={connecting:U("connecting"),connected:U("connected"),lost:U("lost"),refused:U("refused"),replaying:U("replaying")};this.status.className=`status ${e}`,this.status.textContent=n[e],e==="refused"&&(ki.removeItem("name"),Qe(this.app,k("main",{className:"refused",role:"alert"},k("h1",{},U("refused")),k("p",{},Wt(t)),lt("↻",()=>location.reload()))))}toast(e,t){if(this.toasts.lastElementChild?.firstElementChild?.textContent===e())return;const n=k("button",{type:"button",onclick:()=>s.remove()},k("span",{"aria-hidden":"true"},"×"),k("span",{className:"hidden"},oi(()=>U("close")))),s=k("div",{className:`toast ${t}`},oi(e),n);this.toasts.querySelectorAll(t==="error"?".toast.error":".toast:not(.error)").forEach(o=>o.remove()),this.toasts.append(s),window.setTimeout(()=>s.remove(),t==="error"?15e3:6e3)}speak(e){Qu(e),os.setItem("language",e),this.build(),this.says(this.state),uc(this.app),this.app.querySelector("[data-key=language]")?.focus()}theme(e){const t=e?e==="dark":matchMedia("(prefers-color-scheme: dark)").matches;document.documentElement.dataset.theme=t?"dark":"light",e&&os.setItem("theme",e),this.room.paint(),N.changed&&this.charts.build(),this.panel.firstChild&&this.fill()}help(){const e=["impulse","size","front","back","pull","tilt","step"].map(h=>[U(h==="pull"?"pullBoth":h==="back"?"backPush":h),U(`${h}Tip`)]),[t,n,s,...o]=bh().keys,a=(matchMedia("(hover: none)").matches?[s,...e]:[...e,t,n,s,...o]).map(([h,u])=>k("tr",{},k("th",{scope:"row"},h),k("td",{},u))),l=k("h2",{tabIndex:-1},U("help")),c=k("dialog",{className:"help","aria-label":U("help"),onclose:()=>c.remove()},l,k("table",{},k("tbody",{},...a)),lt(U("close"),()=>c.close(),{className:"main"}));this.app.append(c),c.showModal(),l.focus(),c.scrollTop=0}key(e){const t=e.target;if(!(e.ctrlKey||e.metaKey||e.altKey||/^(INPUT|SELECT|TEXTAREA|DIALOG)$/.test(t.tagName))&&!(e.key===" "&&t.tagName==="BUTTON")){if(e.key==="?")this.help();else if(e.key===" ")this.pause();else if(e.key===".")N.send({kind:"Step",periods:1});else if(e.key===","||e.key==="/")this.seek(e.key===","?-.25:.25);else if(e.key==="s")this.stand();else if(e.key==="n"||e.key==="p")this.toured(e.key==="n"?1:-1);else if(e.key==="k")N.push({kind:"Strike",what:"impulse",size:this.knock});else if(/^[1-8]$/.test(e.key)&&document.getElementById(`tab-${this.tabAt(e.key)}`))this.open(this.tabAt(e.key));else return;e.preventDefault()}}tabAt(e){return(Jt?Hf:zf)[Number(e)-1]}toured(e){const t=this.tab==="Tour";t||this.open("Tour"),this.tour.move(t?e:0)}look(e){const t={"[":[-.15,0],"]":[.15,0],"{":[0,-.1],"}":[0,.1]};e.key in t&&this.room.turn(...t[e.key]),e.key==="+"&&this.room.zoom(.9),e.key==="-"&&this.room.zoom(1.1)}frame(e){N.snapshot&&this.room.move(N.snapshot),this.room.draw(e-this.drawn),this.drawnFirst&&e>this.seen+sI?this.deepen():N.snapshot&&!this.drawnFirst&&([this.drawnFirst,this.seen]=[!0,e]),this.drawn=e,e-this.plotted>45&&(this.charts.draw(),this.tab==="See"&&this.see.draw(),this.plotted=e),e-this.said>2e3&&(this.describe(),this.said=e),this.steering.tick(e),requestAnimationFrame(t=>this.frame(t))}describe(){const[e,t]=[N.snapshot,N.changed];if(!e||!t)return;const n=wn(t.bodies[0]),s=(t.look.wheel_radius*e.x[0][2]*100).toFixed(0),o=e.x[0][8]?U("fellNow",{body:n}):U("sceneNow",{body:n,pitch:(e.x[0][0]*180/Math.PI).toFixed(1),way:s});this.spoken.textContent=o,this.room.element.setAttribute("aria-label",`${U("scene")} ${o}`)}picture(){return this.room.picture([N.setup.robot,wn(N.setup.controller),`${ss(N.snapshot?.t??0,1)} s`,"upright lab"].join("  ·  "))}address(){return Ch()}grasp(){return this.room.grasp()}}const aI=new rI(document.getElementById("app"));Object.assign(window,{upright:{store:N,page:aI,exported:Jt}});
